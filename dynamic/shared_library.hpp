#pragma once

#include <string>

namespace raycat {

/// A shared library of this machine that is loaded where it is needed, so that the program starts
/// without it. Its functions have the types that its headers give them:
///
///     const SharedLibrary cairo("libcairo.so.2");
///     decltype(cairo_create)* const create = cairo["cairo_create"];
///
/// It stays loaded until the program ends, since libraries leave behind what refers to them. To
/// load it again costs next to nothing.
class SharedLibrary {
 public:
  /// Loads the library of this name, which the system looks for. Throws `std::runtime_error` with
  /// the system's reason, which names it, if it cannot.
  explicit SharedLibrary(std::string name);

  /// A function that becomes a pointer of any type; the type must be its own.
  class Function {
   public:
    template <typename Type>
    operator Type*() const {
      return reinterpret_cast<Type*>(address_);
    }

   private:
    friend class SharedLibrary;
    explicit Function(void* address) : address_(address) {}

    void* address_;
  };

  /// Throws `std::runtime_error` that names both if the library has no such function.
  Function operator[](const char* function) const;

 private:
  std::string name_;
  void* handle_;
};

}  // namespace raycat
