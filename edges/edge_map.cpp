#include "edges/edge_map.hpp"

#include <numeric>

namespace raycat {

std::size_t EdgeMap::count() const {
  return std::accumulate(pixels.begin(), pixels.end(), std::size_t{0});
}

EdgeMap detect_edges(const CategoryImage& categories) {
  EdgeMap map{.width = categories.width, .height = categories.height, .pixels = {}};
  map.pixels.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const CategoryId here = categories.at(x, y);
      map.pixels.push_back(here != categories.at(x + 1, y) || here != categories.at(x, y + 1) ||
                                   here != categories.at(x + 1, y + 1)
                               ? 1
                               : 0);
    }
  }
  return map;
}

EdgeMap selected_pixels(const EdgeMap& edges, const CategoryImage& categories) {
  EdgeMap selected(edges);
  if (categories.textured.empty()) {
    return selected;
  }
  const auto columns = static_cast<std::size_t>(categories.width) + 1;
  std::size_t pixel = 0;
  for (std::size_t y = 0; y < static_cast<std::size_t>(edges.height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(edges.width); ++x, ++pixel) {
      selected.pixels[pixel] |= categories.textured[y * columns + x];
    }
  }
  return selected;
}

}  // namespace raycat
