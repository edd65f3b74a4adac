#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "categories/category_table.hpp"
#include "categories/detail.hpp"
#include "categories/encoder.hpp"

namespace raycat {

/// The categories of an image's samples, on a lattice with one column and one row more than the
/// image has pixels: pixel (x, y) is the square of the samples (x, y), (x+1, y), (x, y+1) and
/// (x+1, y+1) (Section 3, Fig. 6a). Sample (x, y) goes through the centre of pixel (x, y).
struct CategoryImage {
  int width = 0;                    ///< in pixels
  int height = 0;                   ///< in pixels
  std::vector<CategoryId> samples;  ///< (width + 1) * (height + 1), rows from the top
  CategoryTable table;              ///< numbered by first appearance in `samples`

  /// 1 for each sample whose ray met a textured surface (Section 4.2). Empty if none can.
  std::vector<std::uint8_t> textured;

  std::optional<Encoder> encoder;  ///< that made the words of `table`; nothing if another way did
  Detail detail;                   ///< what the categories keep of ray trees

  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width) + 1) +
           static_cast<std::size_t>(x);
  }
  CategoryId at(int x, int y) const { return samples[index(x, y)]; }

  /// The samples of pixel (x, y)'s square: left to right, top to bottom.
  std::array<CategoryId, 4> square(int x, int y) const {
    return {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
  }

  std::size_t bytes() const noexcept {
    return samples.capacity() * sizeof(samples[0]) + textured.capacity() + table.bytes();
  }
};

/// How many pixels have each category, by number: the sizes of the equivalence classes.
std::vector<std::uint64_t> pixels_per_category(const CategoryImage& image);

/// How many pixels have a category of whose words `is` is true; it is asked once a category.
template <typename Is>
std::uint64_t count_pixels(const CategoryImage& image, const Is& is) {
  const std::vector<std::uint64_t> pixels = pixels_per_category(image);
  std::uint64_t count = 0;
  for (std::size_t id = 0; id < pixels.size(); ++id) {
    count += is(image.table.words(CategoryId{static_cast<std::uint32_t>(id)})) ? pixels[id] : 0;
  }
  return count;
}

/// Pixels whose ray met a textured surface.
std::uint64_t textured_pixels(const CategoryImage& image);

}  // namespace raycat
