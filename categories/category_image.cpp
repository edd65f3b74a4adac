#include "categories/category_image.hpp"

namespace raycat {

std::vector<std::uint64_t> pixels_per_category(const CategoryImage& image) {
  std::vector<std::uint64_t> pixels(image.table.size());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      ++pixels[static_cast<std::size_t>(image.at(x, y))];
    }
  }
  return pixels;
}

std::uint64_t textured_pixels(const CategoryImage& image) {
  std::uint64_t pixels = 0;
  const auto columns = static_cast<std::size_t>(image.width) + 1;
  for (std::size_t i = 0; i < image.textured.size(); ++i) {
    const bool pixel =
        i % columns != columns - 1 && i < columns * static_cast<std::size_t>(image.height);
    pixels += pixel && image.textured[i] != 0 ? 1u : 0u;
  }
  return pixels;
}

}  // namespace raycat
