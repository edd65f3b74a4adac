#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace raycat {

/// Bytes of a file as they are put together, numbers in little-endian order.
class ByteBuffer {
 public:
  template <typename Number>
  void put(Number number) {
    static_assert(std::endian::native == std::endian::little && std::is_arithmetic_v<Number>);
    const std::size_t end = bytes_.size();
    bytes_.resize(end + sizeof(Number));
    std::memcpy(bytes_.data() + end, &number, sizeof(Number));
  }

  void put(std::string_view text) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + text.size());
    std::copy_n(std::as_bytes(std::span(text)).begin(), text.size(),
                bytes_.begin() + static_cast<std::ptrdiff_t>(end));
  }

  /// Adds `filler` until the size is a multiple of `alignment`.
  void align(std::size_t alignment, char filler = '\0') {
    while (bytes_.size() % alignment != 0) {
      put(filler);
    }
  }

  std::size_t size() const noexcept { return bytes_.size(); }
  std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace raycat
