#include "modelling/mesh_minkowski_sum.hpp"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TriangleMesh mesh(std::vector<glm::dvec3> positions, std::vector<glm::uvec3> triangles) {
  TriangleMesh out;
  out.positions = std::move(positions);
  out.faces.assign(triangles.size(), 0);
  out.triangles = std::move(triangles);
  out.face_count = 1;
  return out;
}

TEST_CASE("the Minkowski sum with a mesh that encloses nothing is nothing", "[modelling]") {
  const TriangleMesh solid = mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const TriangleMesh flat = mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  CHECK(minkowski_sum(solid, flat).triangles.empty());
  CHECK(minkowski_sum(flat, solid).triangles.empty());
  CHECK(signed_volume(minkowski_sum(solid, solid)) == Approx(8.0 / 6.0));
}

}  // namespace
}  // namespace raycat
