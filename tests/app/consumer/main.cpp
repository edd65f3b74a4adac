#include <cstdio>

#include <raycat/categories/category_image.hpp>
#include <raycat/edges/edge_map.hpp>
#include <raycat/geometry/placed_shape.hpp>
#include <raycat/io/load_scene.hpp>
#include <raycat/render/render.hpp>

// Uses one thing of each library: an edge between two categories, a crossing, and a scene file
// rendered.
int main(int argc, char** argv) {
  raycat::CategoryImage image{.width = 1, .height = 1};
  for (const std::uint32_t word : {1u, 1u, 1u, 2u}) {
    image.samples.push_back(image.table.intern({&word, 1}));
  }
  bool right = raycat::detect_edges(image).count() == 1;

  raycat::Crossings crossings;
  raycat::PlacedShape(raycat::Sphere{.radius = 2.0})
      .cross({.origin = {0, 0, 5}, .direction = {0, 0, -1}}, crossings);
  right &= crossings.size() == 2 && crossings[0].t == 3.0;

  const raycat::SceneFile file = raycat::load_scene(argc > 1 ? argv[1] : "");
  const raycat::Accel accel(file.scene);
  const raycat::Rendering rendering =
      raycat::render(accel, file.scene.cameras.at(0), {.width = 60, .height = 40, .levels = 2});
  const std::size_t edges = raycat::detect_edges(rendering.categories).count();
  right &= edges > 100 && edges < 1200 && rendering.rays.camera == 61 * 41;

  std::puts(right ? "raycat works" : "raycat is wrong");
  return right ? 0 : 1;
}
