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
      map.pixels.push_back(is_edge(categories.square(x, y)) ? 1 : 0);
    }
  }
  return map;
}

EdgeMap selected_pixels(const EdgeMap& edges, const CategoryImage& categories) {
  EdgeMap selected(edges);
  std::size_t pixel = 0;
  for (int y = 0; y < edges.height && !categories.textured.empty(); ++y) {
    for (int x = 0; x < edges.width; ++x, ++pixel) {
      selected.pixels[pixel] |= categories.textured[categories.index(x, y)];
    }
  }
  return selected;
}

}  // namespace raycat
