#include "io/images/indexed_png.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include <fmt/format.h>

#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/images/png_file.hpp"

namespace raycat {

namespace fs = std::filesystem;

void require_indexed_path(const fs::path& path) {
  std::error_code ignored;
  if (lower_extension(path) != ".png" && !fs::is_character_file(path, ignored)) {
    throw std::invalid_argument(fmt::format("{}: indexed images end in .png", path.string()));
  }
}

void write_indexed_png(const fs::path& path, const IndexedImage& image,
                       std::span<const std::array<std::uint8_t, 3>> palette,
                       const Provenance& provenance) {
  require_indexed_path(path);
  assert(std::ranges::all_of(image.pixels, [&](std::uint8_t i) { return i < palette.size(); }));

  std::vector<std::byte> file;
  try {
    file = png_file({.width = image.width,
                     .height = image.height,
                     .pixel = PngPixel::index,
                     .bytes = image.pixels,
                     .palette = palette},
                    provenance);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path.string(), error.what()));
  }
  write_file(path, file);
}

}  // namespace raycat
