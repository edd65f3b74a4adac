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
  for (int y = 0; y < image.height && !image.textured.empty(); ++y) {
    for (int x = 0; x < image.width; ++x) {
      pixels += image.textured[image.index(x, y)];
    }
  }
  return pixels;
}

}  // namespace raycat
