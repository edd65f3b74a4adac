// Meshes as operands, beside the shapes that they stand for.

#include <cmath>
#include <memory>
#include <variant>

#include <catch2/catch.hpp>

#include "csg/solid.hpp"
#include "geometry/mesh.hpp"
#include "tests/csg/random_models.hpp"

namespace raycat {
namespace {

Model as_meshes(Model model) {
  for (CsgLeaf& leaf : model.leaves) {
    const auto& box = std::get<Box>(leaf.shape.shape());
    leaf.shape =
        PlacedShape(std::make_shared<const ClosedMesh>(box_mesh(box.size)), leaf.shape.transform());
  }
  return model;
}

// Along an axis, never in a face, and often through the edge between the two triangles of one.
Ray lattice_ray(Random& random) {
  glm::dvec3 origin;
  glm::dvec3 direction(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    origin[axis] = 0.25 * static_cast<double>(1 + 2 * (random() % 14));
  }
  direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 1.0 : -1.0;
  return {.origin = origin - 16.0 * direction, .direction = direction};
}

TEST_CASE("boxes as meshes give the boundaries of boxes, also through edges", "[csg][mesh]") {
  int boundaries = 0;
  int different = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const Model boxes = any_model(seed, integer_box);
    const Solid solid = solid_of(boxes);
    const Solid meshes = solid_of(as_meshes(boxes));
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
      const Ray ray = lattice_ray(random);
      const auto expected = surfaces(solid, ray);
      boundaries += static_cast<int>(expected.size());
      different += surfaces(meshes, ray) == expected ? 0 : 1;
    }
  }
  CAPTURE(boundaries);
  CHECK(boundaries > 10'000);
  CHECK(different == 0);
}

}  // namespace
}  // namespace raycat
