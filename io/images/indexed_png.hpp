#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "io/images/provenance.hpp"

namespace raycat {

/// An image whose pixels are values, not colours.
struct IndexedImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< width * height, rows from the top
};

/// Throws `std::invalid_argument` unless `path` ends in .png or is a device, which is sent PNG.
void require_indexed_path(const std::filesystem::path& path);

/// Writes `image` as PNG with `palette`, sRGB: a viewer shows the colours, and a program that
/// reads the indices gets the values. There are 1 to 256 colours, and one for each value in
/// `image`. The file is there whole or not at all. Throws as `require_indexed_path` does, and
/// `std::runtime_error` if it cannot be written.
void write_indexed_png(const std::filesystem::path& path, const IndexedImage& image,
                       std::span<const std::array<std::uint8_t, 3>> palette,
                       const Provenance& provenance);

}  // namespace raycat
