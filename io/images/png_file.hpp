#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/images/provenance.hpp"

namespace raycat {

/// What a pixel of a PNG is: three bytes of colour, these and one of straight alpha, or the place
/// of its colour in a palette.
enum class PngPixel { rgb, rgba, index };

/// An image in sRGB, as PNG has it.
struct PngImage {
  int width = 0;
  int height = 0;
  PngPixel pixel = PngPixel::rgb;
  std::span<const std::uint8_t> bytes;                   ///< rows from the top
  std::span<const std::array<std::uint8_t, 3>> palette;  ///< of indices: 1 to 256 colours
};

/// The bytes of its file, always the same of one image. Throws `std::runtime_error` with libpng's
/// reason alone.
std::vector<std::byte> png_file(const PngImage& image, const Provenance& provenance);

}  // namespace raycat
