#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace raycat {

/// An array whose elements have no value until they are given one: for those that several threads
/// fill in, for which setting all to zero first would take as long as the work itself.
template <typename T>
class RawArray {
 public:
  RawArray() = default;
  explicit RawArray(std::size_t size)
      : size_(size), elements_(std::make_unique_for_overwrite<T[]>(size)) {}

  std::size_t size() const noexcept { return size_; }
  T& operator[](std::size_t i) noexcept { return elements_[i]; }
  const T& operator[](std::size_t i) const noexcept { return elements_[i]; }
  T* begin() noexcept { return elements_.get(); }
  T* end() noexcept { return elements_.get() + size_; }
  const T* begin() const noexcept { return elements_.get(); }
  const T* end() const noexcept { return elements_.get() + size_; }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<T[]> elements_;
};

}  // namespace raycat
