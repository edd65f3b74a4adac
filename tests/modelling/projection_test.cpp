#include "modelling/projection.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "modelling/extrusion.hpp"
#include "tests/modelling/sample_contours.hpp"

namespace raycat {
namespace {

TriangleMesh block(double side, double z0, double height) {
  return linear_extrusion({{square(0, 0, side)}}, {.height = height, .z0 = z0});
}

TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t i = 0; i < b.triangles.size(); ++i) {
    a.triangles.push_back(b.triangles[i] + first);
    a.faces.push_back(a.face_count + b.faces[i]);
  }
  a.face_count += b.face_count;
  return a;
}

TEST_CASE("a block has its section wherever the plane meets it", "[modelling][projection]") {
  CHECK(area(section(block(3, -1, 2))) == 9.0);
  CHECK(area(section(block(3, 0, 2))) == 9.0);
  CHECK(area(section(block(3, -2, 2))) == 9.0);
  CHECK(section(block(3, 1, 2)).contours.empty());
  CHECK(section(block(3, -3, 2)).contours.empty());
  CHECK(section({}).contours.empty());
}

TEST_CASE("an open face in the plane is left out of a section", "[modelling][projection]") {
  const TriangleMesh low = block(3, -2, 2);  // face 0 is its bottom, 1 its top
  CHECK(section(low, {false, true}).contours.empty());
  CHECK(area(section(low, {true, false})) == 9.0);
}

TEST_CASE("a cone is cut at a smaller circle", "[modelling][projection]") {
  const TriangleMesh cone =
      linear_extrusion({{circle(2.0, 90)}}, {.height = 4.0, .z0 = -1.0, .scale = glm::dvec2(0.0)});
  const double at_bottom = 90 * 0.5 * 4.0 * std::sin(2.0 * std::numbers::pi / 90.0);
  CHECK(area(section(cone)) == Approx(at_bottom * 0.75 * 0.75));
  CHECK(area(shadow(cone)) == Approx(at_bottom));
}

TEST_CASE("a shadow unites what lies above itself", "[modelling][projection]") {
  const TriangleMesh tower = both(block(4, 0, 1), block(2, 1, 5));
  CHECK(area(shadow(tower)) == 16.0);
  CHECK(area(shadow(both(block(4, 0, 1), block(6, 7, 1)))) == 36.0);
  const TriangleMesh ring = rotate_extrusion({{square(2, 0, 1)}}, {.fragments = 60});
  const double facet = std::sin(2.0 * std::numbers::pi / 60.0);
  CHECK(area(shadow(ring)) == Approx(60 * 0.5 * facet * (9.0 - 4.0)));
  CHECK(shadow({}).contours.empty());
}

TEST_CASE("the shadow of many triangles takes a moment", "[modelling][projection]") {
  const Polygons moved = transformed({{circle(1.0, 200)}}, {{1, 0}, {0, 1}, {5, 0}});
  const TriangleMesh large = rotate_extrusion(moved, {.fragments = 200});
  CHECK(large.triangles.size() == 80'000);
  CHECK(area(shadow(large)) == Approx(std::numbers::pi * (36.0 - 16.0)).epsilon(1e-3));
}

}  // namespace
}  // namespace raycat
