#include <cstdio>

#include <geometry/mesh.hpp>  // ours, not raycat's
#include <raycat/categories/category_image.hpp>
#include <raycat/edges/edge_map.hpp>

#if __has_include(<geometry/shape.hpp>) || __has_include(<io/load_scene.hpp>)
#error "raycat's headers are to be had without its name"
#endif

int main() {
  raycat::CategoryImage image{.width = 1, .height = 1};
  for (const unsigned word : {1u, 1u, 1u, 2u}) {
    image.samples.push_back(image.table.intern({&word, 1}));
  }
  const bool right =
      raycat::detect_edges(image).count() == static_cast<unsigned>(parent::own_header);
  std::puts(right ? "edges are found" : "edges are not found");
  return right ? 0 : 1;
}
