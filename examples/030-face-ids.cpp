// The face under each pixel of a model: of a CSG part, the leaf that the surface came from and
// which of the leaf's faces it is, as 64 x 48 numbers.
//
//     030-face-ids part.csg
#include <cstdint>
#include <cstdio>

#include <raycat/raycat.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::puts("usage: 030-face-ids SCENE");
    return 2;
  }
  const raycat::SceneView scene(argv[1]);

  // Keep only what the camera sees directly, without lights.
  const raycat::Detail seen{.levels = 1, .lights = false};
  const raycat::CategoryImage image =
      scene.render({.width = 64, .height = 48, .levels = 1, .detail = seen}).categories;

  raycat::CategoryTrees trees(image);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const raycat::RayTree& tree = trees.tree(image.at(x, y));
      std::printf("%4d", tree.empty() ? -1 : static_cast<int>(tree.front().surface));
    }
    std::printf("\n");
  }

  // Print their names.
  const raycat::SurfaceTable& surfaces = scene.scene().surfaces;
  for (std::uint32_t face = 0; face < surfaces.faces(); ++face) {
    const raycat::SurfaceId id{face};
    std::printf("%u: face %u of %s in %s\n", face, surfaces.face_in_primitive(id),
                surfaces.name(surfaces.primitive(id)).c_str(),
                surfaces.name(surfaces.object(id)).c_str());
  }
}
