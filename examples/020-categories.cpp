// The categories of a picture's middle row: which there are, and the ray tree that each stands for.
//
//     020-categories room.gltf
#include <cstdio>

#include <raycat/raycat.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::puts("usage: 020-categories SCENE");
    return 2;
  }
  const raycat::SceneView scene(argv[1]);
  const raycat::CategoryImage categories = scene.render({.width = 64, .height = 64}).categories;

  // A category is a number: pixels of one number saw the same surfaces under the same lights, also
  // in mirrors and through glass. The tree says which surfaces and lights: position 1 is what the
  // camera sees, 2p what is seen from p by refraction and 2p + 1 by reflection; children come
  // first; no nodes mean background. Bit i of `lights` is light i.
  raycat::CategoryTrees trees(categories);
  const raycat::SurfaceTable& surfaces = scene.scene().surfaces;
  for (int x = 0; x < 64; ++x) {
    const raycat::CategoryId here = categories.at(x, 32);
    if (x > 0 && here == categories.at(x - 1, 32)) {
      continue;  // no edge between this pixel and the one to the left
    }
    std::printf("from pixel %d: category %u\n", x, static_cast<unsigned>(here));
    for (const raycat::RayNode& node : trees.tree(here)) {
      std::printf("  position %llu: %s, lights %llx\n",
                  static_cast<unsigned long long>(node.position),
                  surfaces.name(surfaces.primitive(node.surface)).c_str(),
                  static_cast<unsigned long long>(node.lights));
    }
  }
}
