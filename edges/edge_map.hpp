#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "categories/category_image.hpp"

namespace raycat {

/// Which pixels of an image are on an edge.
struct EdgeMap {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 1 on an edge, else 0; rows from the top

  bool at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)] != 0;
  }
  std::size_t count() const;
};

/// Are the samples of a square not all of one category?
constexpr bool is_edge(const std::array<CategoryId, 4>& corners) noexcept {
  return corners[0] != corners[1] || corners[0] != corners[2] || corners[0] != corners[3];
}

/// A pixel is on an edge when its four samples are not all of one category (Section 3, Fig. 6a).
/// The sample of a pixel is compared with its three neighbours, and since these are compared
/// with it alone, the four are equal exactly when the pairs are.
EdgeMap detect_edges(const CategoryImage& categories);

/// The pixels to oversample (Section 4): those on an edge and those whose ray met a textured
/// surface, which categories take for uniform (Section 4.2).
EdgeMap selected_pixels(const EdgeMap& edges, const CategoryImage& categories);

}  // namespace raycat
