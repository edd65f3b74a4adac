#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace raycat {

/// Numbers of a binary file, one after the other.
class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view bytes, std::endian order) : bytes_(bytes), order_(order) {}

  std::size_t left() const noexcept { return bytes_.size(); }

  /// Throws `std::invalid_argument` where the file ends before it.
  void skip(std::size_t count) {
    if (count > bytes_.size()) {
      throw std::invalid_argument("is truncated");
    }
    bytes_.remove_prefix(count);
  }

  /// The next. Throws as `skip` does.
  template <typename Number>
  Number take() {
    const std::string_view from = bytes_;
    skip(sizeof(Number));
    std::array<char, sizeof(Number)> raw{};
    std::ranges::copy(from.substr(0, raw.size()), raw.begin());
    if (order_ != std::endian::native) {
      std::ranges::reverse(raw);
    }
    return std::bit_cast<Number>(raw);
  }

 private:
  std::string_view bytes_;
  std::endian order_;
};

}  // namespace raycat
