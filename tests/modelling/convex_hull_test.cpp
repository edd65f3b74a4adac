#include "modelling/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

namespace raycat {
namespace {

TEST_CASE("the hull of a cube's corners and points inside is the cube", "[modelling][hull]") {
  std::vector<glm::dvec3> points;
  for (int corner = 0; corner < 8; ++corner) {
    points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.01, 0.99);
  for (int i = 0; i < 100; ++i) {
    points.emplace_back(place(random), place(random), place(random));
  }
  const TriangleMesh hull = convex_hull(points);
  CHECK(hull.positions.size() == 8);
  CHECK(hull.triangles.size() == 12);
  double volume = 0.0;
  for (const glm::uvec3& t : hull.triangles) {
    volume += glm::dot(hull.positions[t.x], glm::cross(hull.positions[t.y], hull.positions[t.z]));
  }
  CHECK(volume / 6.0 == Approx(1.0));
}

TEST_CASE("a hull depends on the set of its points alone", "[modelling][hull]") {
  // Facets, edges and corners are full of points, as are those of a prism of eight sides.
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 7 * 7 * 4; ++i) {
    const glm::dvec3 p(i % 7 - 3, i / 7 % 7 - 3, i / 49);
    if (std::abs(p.x) + std::abs(p.y) < 5) {
      points.push_back(p);
    }
  }
  const TriangleMesh hull = convex_hull(points);
  CHECK(hull.positions.size() == 16);
  CHECK(hull.triangles.size() == 28);

  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    std::ranges::shuffle(points, random);
    points.push_back(-points.front() * 0.0);  // inside, with signs on some of its zeros
    const TriangleMesh again = convex_hull(points);
    REQUIRE(again.positions == hull.positions);
    REQUIRE(again.triangles == hull.triangles);
  }
}

TEST_CASE("points in a plane, in a row or at one place have no hull", "[modelling][hull]") {
  const std::vector<std::vector<glm::dvec3>> flat{{},
                                                  {{1, 2, 3}},
                                                  {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
                                                  {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},
                                                  {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
  for (const auto& points : flat) {
    CHECK(convex_hull(points).triangles.empty());
  }
}

}  // namespace
}  // namespace raycat
