// The lines of a scene: where neighbouring pixels see different things.
//
//     010-lines part.csg lines.png
#include <cstdio>
#include <exception>

#include <raycat/raycat.hpp>

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::puts("usage: 010-lines SCENE LINES.png");
    return 2;
  }
  // A file of any kind that raycat reads. It is framed and lit if it has no camera or light.
  const raycat::SceneView scene(argv[1]);

  // The picture, and of each of its pixels the category: an exact name for all that its ray met.
  const raycat::Rendering picture = scene.render({.width = 900, .height = 700});

  // Edges are where categories differ. No threshold is involved.
  const raycat::EdgeMap edges = raycat::detect_edges(picture.categories);
  raycat::write_image(argv[2], raycat::line_image(edges));
} catch (const std::exception& error) {
  std::fprintf(stderr, "010-lines: %s\n", error.what());  // `FILE: place: what is wrong`
  return 1;
}
