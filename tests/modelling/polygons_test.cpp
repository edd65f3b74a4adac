#include "modelling/polygons.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

#include "modelling/facet_rule.hpp"
#include "modelling/triangulation.hpp"
#include "tests/modelling/sample_contours.hpp"

namespace raycat {
namespace {

TEST_CASE("contours crossing an even number of times enclose nothing", "[modelling][polygons]") {
  // The pentagram: its five points without its heart.
  std::vector<glm::dvec2> star;
  for (int i = 0; i < 5; ++i) {
    star.push_back(unit_vector(144.0 * i));
  }
  const Polygons points = even_odd(std::vector<Contour>{star});
  CHECK(points.contours.size() == 5);
  const double degree = std::numbers::pi / 180.0;
  const double heart = std::cos(72.0 * degree) / std::cos(36.0 * degree);  // its radius
  const double outline = 10.0 * 0.5 * heart * std::sin(36.0 * degree);
  const double inner = 5.0 * 0.5 * heart * heart * std::sin(72.0 * degree);
  CHECK(area(points) == Approx(outline - inner));

  CHECK(area(even_odd(std::vector<Contour>{square(0, 0, 4), square(1, 1, 2)})) == Approx(12.0));
  CHECK(area(even_odd(std::vector<Contour>{square(0, 0, 4), square(0, 0, 4)})) == 0.0);
}

TEST_CASE("outer contours run counter-clockwise and holes clockwise", "[modelling][polygons]") {
  Contour clockwise = square(1, 1, 2);
  std::ranges::reverse(clockwise);
  for (const std::vector<Contour>& contours :
       {std::vector<Contour>{square(0, 0, 4), square(1, 1, 2)},
        std::vector<Contour>{clockwise, square(0, 0, 4)}}) {
    const Polygons ring = even_odd(contours);
    REQUIRE(ring.contours.size() == 2);
    const double first = area({{ring.contours[0]}});
    const double second = area({{ring.contours[1]}});
    CHECK(std::max(first, second) == 16.0);
    CHECK(std::min(first, second) == -4.0);
    CHECK(area(filled(ring)) == 16.0);
    const Polygons mirrored = transformed(ring, {{-1, 0}, {0, 1}, {0, 0}});
    CHECK(area(mirrored) == 12.0);
    CHECK(transformed(ring, {{1, 1}, {1, 1}, {0, 0}}).contours.empty());
  }
}

TEST_CASE("corners in a straight edge are dropped", "[modelling][polygons]") {
  const Polygons joined = combined(
      Operation::set_union, std::array{Polygons{{square(0, 0, 2)}}, Polygons{{square(2, 0, 2)}}});
  REQUIRE(joined.contours.size() == 1);
  CHECK(joined.contours[0].size() == 4);
  CHECK(area(joined) == 8.0);
}

TEST_CASE("contours part where they touch themselves", "[modelling][polygons]") {
  const Polygons touching = combined(
      Operation::set_union, std::array{Polygons{{square(0, 0, 2)}}, Polygons{{square(2, 2, 2)}}});
  CHECK(touching.contours.size() == 2);
  // A square with a square hole, a corner of which touches the side.
  const Polygons pinched =
      even_odd(std::vector<Contour>{square(0, 0, 4), {{0, 2}, {1, 1}, {2, 2}, {1, 3}}});
  CHECK(pinched.contours.size() == 2);
  CHECK(area(pinched) == Approx(14.0));
  CHECK(area(filled(pinched)) == Approx(16.0));
}

TEST_CASE("areas of unions and intersections add up", "[modelling][polygons]") {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    // Small whole coordinates make many edges overlap and many corners meet.
    const double size = i % 2 == 0 ? 4.0 : 1e6;
    const Polygons a = even_odd(std::vector<Contour>{random_contour(random, 3 + i % 9, size)});
    const Polygons b = even_odd(std::vector<Contour>{random_contour(random, 3 + i % 7, size),
                                                     random_contour(random, 5, size)});
    const double both = area(combined(Operation::intersection, std::array{a, b}));
    const double either = area(combined(Operation::set_union, std::array{a, b}));
    const double rest = area(combined(Operation::difference, std::array{a, b}));
    const double margin = 1e-9 * size * size;
    CHECK(both + either == Approx(area(a) + area(b)).margin(margin));
    CHECK(rest + both == Approx(area(a)).margin(margin));
    CHECK(area(combined(Operation::set_union, std::array{a, a, a})) ==
          Approx(area(a)).margin(margin));
    CHECK(area(combined(Operation::difference, std::array{a, b, a})) == Approx(0.0).margin(margin));
  }
}

// Whether a point is inside by the number of edges to its right, which is another way to know.
int winding(const Polygons& polygons, const glm::dvec2& p) {
  int turns = 0;
  for (const Contour& contour : polygons.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const glm::dvec2& a = contour[i];
      const glm::dvec2& b = contour[(i + 1) % contour.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        turns += b.y > a.y ? 1 : -1;
      }
    }
  }
  return turns;
}

TEST_CASE("set operations are those of points", "[modelling][polygons]") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    std::vector<Polygons> operands;
    for (int k = 0; k < 4; ++k) {
      operands.push_back(even_odd(std::vector<Contour>{random_contour(random, 6, 5.0)}));
    }
    const Polygons either = combined(Operation::set_union, operands);
    const Polygons all = combined(Operation::intersection, operands);
    const Polygons rest = combined(Operation::difference, operands);
    for (int k = 0; k < 100; ++k) {
      const glm::dvec2 p(place(random), place(random));
      int count = 0;
      for (const Polygons& operand : operands) {
        CHECK(winding(operand, p) * (winding(operand, p) - 1) == 0);
        count += winding(operand, p);
      }
      CHECK(winding(either, p) == (count > 0 ? 1 : 0));
      CHECK(winding(all, p) == (count == 4 ? 1 : 0));
      CHECK(winding(rest, p) == (count == 1 && winding(operands[0], p) == 1 ? 1 : 0));
    }
  }
}

TEST_CASE("the hull of two squares is a hexagon", "[modelling][polygons]") {
  const Polygons hexagon =
      hull(std::array{Polygons{{square(0, 0, 1)}}, Polygons{{square(3, 3, 1)}}});
  REQUIRE(hexagon.contours.size() == 1);
  CHECK(hexagon.contours[0].size() == 6);
  CHECK(area(hexagon) == Approx(16.0 - 9.0));
  CHECK(hull({}).contours.empty());
}

TEST_CASE("a Minkowski sum of convex contours has the mixed area", "[modelling][polygons]") {
  // |A + B| = |A| + |B| + 2 V(A, B); for a square of side s, V is s times half B's widths.
  const Polygons disc{{circle(1.5, 64)}};
  const Polygons sum = minkowski_sum(Polygons{{square(0, 0, 4)}}, disc);
  CHECK(area(sum) == Approx(16.0 + area(disc) + 4.0 * 3.0 + 4.0 * 3.0));
}

TEST_CASE("a Minkowski sum keeps the holes that the other does not fill", "[modelling][polygons]") {
  const Polygons ring = even_odd(std::vector<Contour>{square(-5, -5, 10), square(-2, -2, 4)});
  CHECK(area(minkowski_sum(ring, Polygons{{square(0, 0, 1)}})) == Approx(121.0 - 9.0));
  CHECK(area(minkowski_sum(Polygons{{square(0, 0, 1)}}, ring)) == Approx(121.0 - 9.0));
  CHECK(area(minkowski_sum(ring, Polygons{{square(0, 0, 4)}})) == Approx(196.0));
  CHECK(minkowski_sum(ring, {}).contours.empty());
  const Polygons two{{square(0, 0, 1), square(10, 0, 1)}};
  CHECK(area(minkowski_sum(two, two)) == Approx(4.0 * 3.0));
}

TEST_CASE("triangles of polygons fill them and run along their edges", "[modelling][polygons]") {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Polygons polygons =
        even_odd(std::vector<Contour>{random_contour(random, 20, 8.0), square(-4, -4, 8)});
    const auto [outline, triangles] = triangulated(polygons);
    std::vector<glm::dvec2> corners;
    for (const Contour& contour : outline.contours) {
      corners.insert(corners.end(), contour.begin(), contour.end());
    }
    double sum = 0.0;
    for (const glm::uvec3& t : triangles) {
      const double size = area({{{corners[t.x], corners[t.y], corners[t.z]}}});
      CHECK(size >= 0.0);
      sum += size;
    }
    CHECK(sum == Approx(area(polygons)));
  }
}

TEST_CASE("large, small and bad coordinates are no matter", "[modelling][polygons]") {
  for (const double size : {1e50, 1e-50, 1e100}) {
    const Polygons cross = combined(Operation::set_union,
                                    std::array{Polygons{{square(0, 0, size)}},
                                               Polygons{{square(0.5 * size, 0.5 * size, size)}}});
    CHECK(area(cross) / size / size == Approx(1.75));
    CHECK(triangulated(cross).triangles.size() == 6);
  }
  const Polygons far =
      combined(Operation::set_union,
               std::array{Polygons{{square(0, 0, 1)}}, Polygons{{square(-1e50, 1, 2e50)}}});
  CHECK(far.contours.size() == 1);
  CHECK_NOTHROW(triangulated(far));
  CHECK_THROWS_WITH(even_odd(std::vector<Contour>{
                        {{0, 0}, {1, 0}, {0, std::numeric_limits<double>::quiet_NaN()}}}),
                    "a polygon has a corner that is not finite");
  CHECK_THROWS_WITH(transformed({{square(0, 0, 1e200)}}, {{1e200, 0}, {0, 1}, {0, 0}}),
                    "a polygon has a corner that is not finite");
  CHECK(even_odd(std::vector<Contour>{{}, {{1, 1}}, {{1, 1}, {2, 2}}}).contours.empty());
}

TEST_CASE("a contour that crosses itself too often is refused", "[modelling][polygons]") {
  std::mt19937 random(4);
  CHECK_THROWS_WITH(even_odd(std::vector<Contour>{random_contour(random, 5000, 1e6)}),
                    "polygons cross each other in too many places");
}

TEST_CASE("edges that overlap in one line are no matter, if not too many",
          "[modelling][polygons]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1e6, 1e6);
  std::vector<Contour> boxes;
  for (int i = 0; i < 500; ++i) {
    const double x = place(random);
    boxes.push_back({{x, 0}, {x + 1e5, 0}, {x + 1e5, 1}, {x, 1}});
  }
  CHECK(even_odd(boxes).contours.size() > 50);
  CHECK_THROWS_AS(even_odd(std::vector<Contour>(1000, boxes[0])), std::length_error);
}

TEST_CASE("a Minkowski sum of large contours is refused", "[modelling][polygons]") {
  const Polygons disc{{circle(1.0, 2000)}};
  CHECK_THROWS_WITH(minkowski_sum(disc, disc),
                    "a Minkowski sum of polygons with 2000 and 2000 corners is too large");
}

TEST_CASE("a large contour takes a moment", "[modelling][polygons]") {
  const Polygons disc{{circle(10.0, 100'000)}};
  const Polygons cut =
      combined(Operation::difference, std::array{disc, Polygons{{square(0, 0, 20)}}});
  CHECK(area(cut) == Approx(75.0 * std::numbers::pi));
  CHECK(triangulated(cut).triangles.size() > 70'000);
}

}  // namespace
}  // namespace raycat
