#include "io/openscad/facets.hpp"

#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"

namespace raycat {
namespace {

using namespace openscad;

double volume(const Facets& facets) {
  const TriangleMesh mesh = triangulate(facets.points, facets.polygons, facets.surface);
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  }
  CHECK_NOTHROW(ClosedMesh(mesh));
  return sum / 6.0;
}

TEST_CASE("a circle has as many corners as OpenSCAD gives it", "[io][openscad]") {
  const FacetRule rule;
  CHECK(facet_count(10.0, rule) == 30);  // 360 / 12
  CHECK(facet_count(1.0, rule) == 5);    // 2 pi / 2, but at least 5
  CHECK(facet_count(4.0, rule) == 13);   // 8 pi / 2
  CHECK(facet_count(1e-7, rule) == 3);   // below OpenSCAD's grid
  CHECK(facet_count(1.0, {.number = 1.0}) == 3);
  CHECK(facet_count(1.0, {.number = 7.0}) == 7);
  CHECK(facet_count(1.0, {.number = 3.9}) == 3);
  CHECK(facet_count(10.0, {.angle = 0.0, .size = 0.0}) == 6284);  // $fs is at least 0.01
  CHECK(facet_count(1000.0, {.angle = 1.0, .size = 1.0}) == 360);
  CHECK_THROWS_WITH(facet_count(1.0, {.number = 1e9}),
                    "circles have at most 1000000 corners, but this has 1e+09");
}

TEST_CASE("a sphere is one surface of rings without poles", "[io][openscad]") {
  const Facets sphere = facet_sphere(10.0, 30);
  CHECK(sphere.points.size() == 15 * 30);
  CHECK(sphere.polygons.size() == 14 * 30 + 2);
  CHECK(std::ranges::count(sphere.surface, 0U) == 14 * 30 + 2);
  CHECK(volume(sphere) == Approx(4112.86).epsilon(1e-6));
}

TEST_CASE("a cylinder has a side and a cap for each radius above zero", "[io][openscad]") {
  const Facets prism = facet_cylinder(3.0, 2.0, 2.0, 4);
  CHECK(prism.polygons.size() == 6);
  CHECK(std::ranges::count(prism.surface, 0U) == 4);
  CHECK(*std::ranges::max_element(prism.surface) == 2);
  CHECK(volume(prism) == Approx(3.0 * 8.0));
  // Corners on the axes are exact.
  CHECK(prism.points[1] == glm::dvec3(0.0, 2.0, 0.0));

  const Facets cone = facet_cylinder(3.0, 2.0, 0.0, 4);
  CHECK(cone.points.size() == 5);
  CHECK(*std::ranges::max_element(cone.surface) == 1);
  CHECK(volume(cone) == Approx(8.0));
  CHECK(volume(facet_cylinder(3.0, 0.0, 2.0, 4)) == Approx(8.0));
  CHECK(volume(facet_cylinder(3.0, 1.0, 2.0, 4)) == Approx(2.0 + 8.0 + 4.0));
}

}  // namespace
}  // namespace raycat
