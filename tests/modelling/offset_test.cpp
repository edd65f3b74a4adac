#include "modelling/offset.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/modelling/sample_contours.hpp"

namespace raycat {
namespace {

TEST_CASE("a square grows by strips and corners", "[modelling][offset]") {
  const Polygons side_3{{square(1, 2, 3)}};
  const double r = 0.7;
  const double strips = 9.0 + 4.0 * r * 3.0;
  // Four arcs of 8 facets make a whole circle of 32.
  const double arcs = 32.0 * 0.5 * r * r * std::sin(2.0 * std::numbers::pi / 32.0);
  CHECK(area(offset(side_3, r, Join::round, 32)) == Approx(strips + arcs));
  CHECK(area(offset(side_3, r, Join::mitre, 32)) == Approx(strips + 4.0 * r * r));
  // Of each corner's square a triangle is cut, r away from the old corner along the diagonal.
  const double cut = (std::numbers::sqrt2 - 1.0) * r;
  CHECK(area(offset(side_3, r, Join::chamfer, 32)) ==
        Approx(strips + 4.0 * r * r - 4.0 * cut * cut));
  for (const Join join : {Join::round, Join::mitre, Join::chamfer}) {
    CHECK(area(offset(side_3, -r, join, 32)) == Approx((3.0 - 2.0 * r) * (3.0 - 2.0 * r)));
    CHECK(offset(side_3, -1.6, join, 32).contours.empty());
    CHECK(area(offset(side_3, 0.0, join, 3)) == Approx(9.0));
    CHECK(offset({}, 1.0, join, 3).contours.empty());
  }
}

TEST_CASE("the last facet of an arc takes what is left", "[modelling][offset]") {
  // 90 degrees are 1.75 facets of a heptagon: two facets, of 51.4 and 38.6 degrees.
  const double r = 2.0;
  const double degree = std::numbers::pi / 180.0;
  const double corner =
      0.5 * r * r * (std::sin(360.0 / 7.0 * degree) + std::sin((90.0 - 360.0 / 7.0) * degree));
  const Polygons grown = offset({{square(0, 0, 10)}}, r, Join::round, 7);
  CHECK(area(grown) == Approx(100.0 + 4.0 * 20.0 + 4.0 * corner));
  REQUIRE(grown.contours.size() == 1);
  CHECK(grown.contours[0].size() == 12);
}

TEST_CASE("holes shrink as the rest grows", "[modelling][offset]") {
  const Polygons ring = even_odd(std::vector<Contour>{square(0, 0, 10), square(3, 3, 4)});
  CHECK(area(offset(ring, 1.0, Join::mitre, 3)) == Approx(144.0 - 4.0));
  CHECK(area(offset(ring, 2.0, Join::mitre, 3)) == Approx(196.0));
  CHECK(area(offset(ring, -1.0, Join::mitre, 3)) == Approx(64.0 - 36.0));
  CHECK(offset(ring, -1.5, Join::mitre, 3).contours.empty());
}

TEST_CASE("a convex contour that grew by mitres shrinks to itself", "[modelling][offset]") {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const Polygons convex = hull(std::array{Polygons{{random_contour(random, 12, 30.0)}}});
    const Polygons back = offset(offset(convex, 3.0, Join::mitre, 3), -3.0, Join::mitre, 3);
    CHECK(area(back) == Approx(area(convex)));
    CHECK(area(combined(Operation::difference, std::array{convex, back})) ==
          Approx(0.0).margin(1e-6));
    // A round offset is the Minkowski sum with a disc, up to the discs' facets.
    const Polygons disc{{circle(3.0, 360)}};
    CHECK(area(offset(convex, 3.0, Join::round, 360)) ==
          Approx(area(minkowski_sum(convex, disc))).epsilon(1e-4));
  }
}

TEST_CASE("growing and then shrinking loses nothing", "[modelling][offset]") {
  std::mt19937 random(2);
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const Polygons any = even_odd(std::vector<Contour>{random_contour(random, 9, 30.0)});
    const Polygons grown = offset(any, 2.0, Join::round, 24);
    CHECK(area(combined(Operation::difference, std::array{any, grown})) ==
          Approx(0.0).margin(1e-6));
    const Polygons closed = offset(grown, -1.9, Join::round, 24);
    CHECK(area(combined(Operation::difference, std::array{any, closed})) ==
          Approx(0.0).margin(1e-6));
  }
}

}  // namespace
}  // namespace raycat
