#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace raycat {

/// 8-bit straight RGBA in row order from the top left.
struct DecodedImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Decodes a PNG or JPEG, told by its content. Throws `std::runtime_error` with the reason if it
/// is neither, broken, or has more than `max_pixels`, which is checked before it is decoded.
DecodedImage decode_image(std::span<const std::uint8_t> bytes, std::uint64_t max_pixels);

}  // namespace raycat
