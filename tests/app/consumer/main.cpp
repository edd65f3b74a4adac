#include <cstdio>

#include <categories/category_image.hpp>
#include <edges/edge_map.hpp>
#include <geometry/placed_shape.hpp>

// Uses one thing of each of three libraries: an edge between two categories, and a crossing.
int main() {
  raycat::CategoryImage image{.width = 1, .height = 1, .samples = {}, .table = {}};
  for (const std::uint32_t word : {1u, 1u, 1u, 2u}) {
    image.samples.push_back(image.table.intern({&word, 1}));
  }
  raycat::Crossings crossings;
  raycat::PlacedShape(raycat::Sphere{.radius = 2.0})
      .cross({.origin = {0, 0, 5}, .direction = {0, 0, -1}}, crossings);
  const bool right =
      raycat::detect_edges(image).count() == 1 && crossings.size() == 2 && crossings[0].t == 3.0;
  std::puts(right ? "raycat works" : "raycat is wrong");
  return right ? 0 : 1;
}
