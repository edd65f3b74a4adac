#include "dynamic/shared_library.hpp"

#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <fmt/format.h>

namespace raycat {

SharedLibrary::SharedLibrary(std::string name)
    : name_(std::move(name)), handle_(::dlopen(name_.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) {
    throw std::runtime_error(fmt::format("a library is missing: {}", ::dlerror()));
  }
}

SharedLibrary::Function SharedLibrary::operator[](const char* function) const {
  void* const address = ::dlsym(handle_, function);
  if (address == nullptr) {
    throw std::runtime_error(fmt::format("the library {} has no {}", name_, function));
  }
  return Function(address);
}

}  // namespace raycat
