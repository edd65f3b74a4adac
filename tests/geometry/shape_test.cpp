#include "geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/facing.hpp"
#include "tests/geometry/lines.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Crossings crossings(const Shape& shape, const Ray& ray) {
  Crossings out;
  CHECK_FALSE(cross(shape, ray, out));
  return out;
}

// How deep a point is within each shape, by formulas that have no line in them. Cones and capsules
// measure across the axis or along a slope, which is at most the distance.
double depth(const Sphere& sphere, const glm::dvec3& p) { return sphere.radius - glm::length(p); }

double depth(const Box& box, const glm::dvec3& p) {
  const glm::dvec3 room = 0.5 * box.size - glm::abs(p);
  return std::min({room.x, room.y, room.z});
}

double depth(const Cylinder& c, const glm::dvec3& p) {
  const double up = p.y / c.height + 0.5;
  const double radius = c.radius_bottom + (c.radius_top - c.radius_bottom) * up;
  const double steepness = std::hypot(1.0, (c.radius_top - c.radius_bottom) / c.height);
  return std::min((radius - std::hypot(p.x, p.z)) / steepness, 0.5 * c.height - std::abs(p.y));
}

// The hull of two balls is the union of the balls between them: the deepest of many.
double depth(const Capsule& c, const glm::dvec3& p) {
  const auto at = [&](double up) {
    const glm::dvec3 center(0.0, c.height * (up - 0.5), 0.0);
    return c.radius_bottom + (c.radius_top - c.radius_bottom) * up - glm::distance(p, center);
  };
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 200; ++i) {  // the depth is concave along the axis
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    (at(a) < at(b) ? low : high) = at(a) < at(b) ? a : b;
  }
  return std::max({at(0.0), at(1.0), at(low)});
}

double depth(const HalfSpace& /*half_space*/, const glm::dvec3& p) { return -p.y; }

double size_of(const Shape& shape) {
  return std::holds_alternative<HalfSpace>(shape) ? 1.0 : glm::length(bounds(shape).max);
}

template <typename S>
void agrees_with_membership(const S& shape, Dice& dice, double away = 5.0) {
  const double size = size_of(shape);
  for (int i = 0; i < 40; ++i) {
    const Ray ray = dice.line(size, away);
    Crossings out;
    const bool inside = cross(shape, ray, out);
    require_in_turn(ray, out, inside);
    require_membership(
        ray, out, inside, [&](const glm::dvec3& p) { return depth(shape, p); }, 2.0 * size,
        (1e-11 + 1e-15 * away) * size, dice);
  }
}

Cylinder any_cylinder(Dice& dice) {
  const double size = dice.scale();
  const auto part = [&] { return size * std::pow(10.0, dice.between(-1.5, 0.0)); };
  Cylinder cylinder{.height = part(), .radius_top = part(), .radius_bottom = part()};
  switch (dice.below(4)) {
    case 0:
      cylinder.radius_top = cylinder.radius_bottom;
      break;
    case 1:
      cylinder.radius_top = 0.0;
      break;
    case 2:
      cylinder.radius_bottom = 0.0;
      break;
    default:
      break;
  }
  return cylinder;
}

Capsule any_capsule(Dice& dice) {
  const Cylinder like = any_cylinder(dice);
  return {.height = dice.below(10) == 0 ? 0.0 : like.height,
          .radius_top = like.radius_top,
          .radius_bottom = like.radius_bottom};
}

TEST_CASE("crossings bound the points that a formula says are inside", "[geometry][shape]") {
  CHECK(rc::check("sphere", [] {
    Dice dice;
    agrees_with_membership(Sphere{dice.scale()}, dice);
  }));
  CHECK(rc::check("box", [] {
    Dice dice;
    const double size = dice.scale();
    agrees_with_membership(
        Box{size * glm::dvec3(dice.between(0.1, 1.0), dice.between(0.1, 1.0), 1.0)}, dice);
  }));
  CHECK(rc::check("cylinder", [] {
    Dice dice;
    agrees_with_membership(any_cylinder(dice), dice);
  }));
  CHECK(rc::check("capsule", [] {
    Dice dice;
    agrees_with_membership(any_capsule(dice), dice);
  }));
  CHECK(rc::check("half-space", [] {
    Dice dice;
    agrees_with_membership(HalfSpace{}, dice);
  }));
}

TEST_CASE("lines from 1e6 sizes away lose no more than their coordinates do", "[geometry][shape]") {
  CHECK(rc::check([] {
    Dice dice;
    agrees_with_membership(Sphere{dice.scale()}, dice, 1e6);
    agrees_with_membership(Box{dice.scale() * glm::dvec3(1.0, 0.4, 0.3)}, dice, 1e6);
    agrees_with_membership(any_cylinder(dice), dice, 1e6);
    agrees_with_membership(any_capsule(dice), dice, 1e6);
  }));
}

// Coordinates of few values make lines that lie in faces, run along edges and meet corners.
TEST_CASE("lines through edges, corners and faces still enter and leave in turn",
          "[geometry][shape]") {
  CHECK(rc::check([] {
    Dice dice;
    const auto coarse = [&] { return 0.5 * (dice.below(9) - 4); };
    const double sizes[] = {1.0, 2.0, 3.0};
    const auto size = [&] { return sizes[dice.below(3)]; };
    const auto radius = [&] { return 0.5 * dice.below(4); };
    for (int i = 0; i < 500; ++i) {
      const double bottom = radius();
      const double top = bottom == 0.0 ? 1.0 : radius();
      const Shape shapes[] = {Sphere{size()},
                              Box{{size(), size(), size()}},
                              Cylinder{size(), top, bottom},
                              Capsule{size(), top, bottom},
                              Torus{size(), size()},
                              HalfSpace{}};
      const Ray ray{.origin{coarse(), coarse(), coarse()},
                    .direction{coarse(), coarse(), coarse()}};
      if (ray.direction == glm::dvec3(0.0)) {
        continue;
      }
      for (const Shape& shape : shapes) {
        Crossings out;
        const bool inside = cross(shape, ray, out);
        require_in_turn(ray, out, inside);
        RC_ASSERT((std::holds_alternative<HalfSpace>(shape) || out.size() % 2 == 0));
        for (const Crossing& crossing : out) {
          RC_ASSERT(crossing.face < face_count(shape));
        }
      }
    }
  }));
}

TEST_CASE("two shapes that share a face never both hold a line in it", "[geometry][shape]") {
  const auto axis = GENERATE(0, 1, 2);
  const auto way = GENERATE(1, 2);
  const Box box{{2.0, 2.0, 2.0}};
  Ray in_upper{.origin = glm::dvec3(0.25), .direction = glm::dvec3(0.0)};
  in_upper.direction[(axis + way) % 3] = 1.0;
  Ray in_lower = in_upper;
  in_upper.origin[axis] = 1.0;  // seen from the box below, and from the one above
  in_lower.origin[axis] = -1.0;
  CHECK(crossings(box, in_upper).empty());
  CHECK(crossings(box, in_lower).size() == 2);
}

TEST_CASE("a cylinder holds lines in its bottom but not in its top", "[geometry][shape]") {
  const Cylinder cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 0.5};
  CHECK(crossings(cylinder, {.origin{0.0, 1.0, 0.0}, .direction{1.0, 0.0, 0.0}}).empty());
  const Crossings bottom =
      crossings(cylinder, {.origin{0.0, -1.0, 0.0}, .direction{1.0, 0.0, 0.0}});
  REQUIRE(bottom.size() == 2);
  CHECK(bottom[0].t == -0.5);
  CHECK(bottom[1].t == 0.5);
}

TEST_CASE("a line that only touches does not cross", "[geometry][shape]") {
  const Ray tangent{.origin{-3.0, 0.0, 1.0}, .direction{1.0, 0.0, 0.0}};
  CHECK(crossings(Sphere{1.0}, tangent).empty());
  CHECK(crossings(Cylinder{2.0, 1.0, 1.0}, tangent).empty());
  CHECK(crossings(Capsule{2.0, 1.0, 1.0}, tangent).empty());
  CHECK(crossings(Torus{0.75, 0.25}, tangent).empty());
  const Ray up{.origin{0.0, -3.0, 1.0}, .direction{0.0, 1.0, 0.0}};
  CHECK(crossings(Cylinder{2.0, 1.0, 1.0}, up).empty());
  CHECK(crossings(Capsule{2.0, 1.0, 1.0}, up).empty());
  const Ray past_edge{.origin{2.0, 0.0, 0.0}, .direction{-1.0, 1.0, 0.0}};
  CHECK(crossings(Box{{2.0, 2.0, 2.0}}, past_edge).empty());
  const Ray past_apex{.origin{-3.0, 1.0, 0.0}, .direction{1.0, 0.0, 0.0}};
  CHECK(crossings(Cylinder{2.0, 0.0, 1.0}, past_apex).empty());
}

TEST_CASE("a box is crossed by a diagonal at its corners", "[geometry][shape]") {
  const Crossings out =
      crossings(Box{{2.0, 4.0, 6.0}}, {.origin = glm::dvec3(0.0), .direction{0.5, 1.0, 0.25}});
  REQUIRE(out.size() == 2);
  CHECK(out[0] == Crossing{.t = -2.0, .normal{-1.0, 0.0, 0.0}, .face = 0, .entering = true});
  CHECK(out[1] ==
        Crossing{.t = 2.0, .normal{1.0, 0.0, 0.0}, .face = 1, .piece = 1, .entering = false});
}

TEST_CASE("each side of a box has its own face", "[geometry][shape]") {
  const auto axis = GENERATE(0U, 1U, 2U);
  Ray ray{.origin = glm::dvec3(0.0), .direction = glm::dvec3(0.0)};
  ray.direction[static_cast<int>(axis)] = 1.0;
  const Crossings out = crossings(Box{}, ray);
  REQUIRE(out.size() == 2);
  CHECK(out[0].face == 2 * axis);
  CHECK(out[1].face == 2 * axis + 1);
}

TEST_CASE("a line along a cone's axis leaves at the apex, through the side", "[geometry][shape]") {
  const Ray up{.origin = glm::dvec3(0.0), .direction{0.0, 1.0, 0.0}};
  const Crossings cone = crossings(Cylinder{2.0, 0.0, 1.0}, up);
  REQUIRE(cone.size() == 2);
  CHECK(cone[0] ==
        Crossing{.t = -1.0, .normal{0.0, -1.0, 0.0}, .face = 1, .piece = 1, .entering = true});
  CHECK(cone[1].t == 1.0);
  CHECK(cone[1].face == 0);
  CHECK(cone[1].normal.y > 0.0);
  const Crossings funnel = crossings(Cylinder{2.0, 1.0, 0.0}, up);
  REQUIRE(funnel.size() == 2);
  CHECK(funnel[0].face == 0);
  CHECK(funnel[1].face == 1);
}

TEST_CASE("a cylinder's faces are side, bottom, top", "[geometry][shape]") {
  const Cylinder cylinder{.height = 2.0, .radius_top = 0.5, .radius_bottom = 1.0};
  const Crossings up = crossings(cylinder, {.origin = glm::dvec3(0.0), .direction{0.0, 2.0, 0.0}});
  REQUIRE(up.size() == 2);
  CHECK(up[0].face == 1);
  CHECK(up[1].face == 2);
  const Crossings over =
      crossings(cylinder, {.origin = glm::dvec3(0.0), .direction{0.0, 0.0, 2.0}});
  REQUIRE(over.size() == 2);
  CHECK(over[0].t == Approx(-0.375));
  CHECK(over[0].face == 0);
  CHECK(over[1].normal.y / over[1].normal.z == Approx(0.25));
}

TEST_CASE("a capsule with one ball inside the other is the outer ball", "[geometry][shape]") {
  const Ray ray{.origin{0.1, 0.2, 5.0}, .direction{0.01, 0.02, -2.0}};
  const Crossings capsule =
      crossings(Capsule{.height = 1.0, .radius_top = 0.5, .radius_bottom = 2.0}, ray);
  const Crossings ball = crossings(
      Sphere{2.0}, {.origin = ray.origin + glm::dvec3(0.0, 0.5, 0.0), .direction = ray.direction});
  REQUIRE(capsule.size() == 2);
  REQUIRE(ball.size() == 2);
  CHECK(capsule[0].t == Approx(ball[0].t).epsilon(1e-14));
  CHECK(capsule[1].t == Approx(ball[1].t).epsilon(1e-14));
}

TEST_CASE("a half-space alone is inside at minus infinity", "[geometry][shape]") {
  Crossings out;
  CHECK(cross(HalfSpace{}, {.origin{0.0, -2.0, 0.0}, .direction{1.0, 0.5, 0.0}}, out));
  REQUIRE(out.size() == 1);
  CHECK(out[0] == Crossing{.t = 4.0, .normal{0.0, 1.0, 0.0}, .face = 0, .entering = false});
  CHECK(cross(HalfSpace{}, {.origin{0.0, -1.0, 0.0}, .direction{1.0, 0.0, 0.0}}, out));
  CHECK_FALSE(cross(HalfSpace{}, {.origin = glm::dvec3(0.0), .direction{1.0, 0.0, 0.0}}, out));
  CHECK_FALSE(cross(HalfSpace{}, {.origin{0.0, 1.0, 0.0}, .direction{1.0, 0.0, 0.0}}, out));
  CHECK(out.size() == 1);
}

TEST_CASE("a chord of 1e-6 of a sphere is right to 1e-9", "[geometry][shape]") {
  const auto size = GENERATE(1e-6, 1.0, 1e6);
  const double offset = 1e-12;
  const Crossings out = crossings(
      Sphere{size}, {.origin{0.0, size * (1.0 - offset), 0.0}, .direction{size, 0.0, 0.0}});
  REQUIRE(out.size() == 2);
  CHECK(out[1].t == Approx(std::sqrt(2.0 * offset)).margin(1e-9));
}

TEST_CASE("a steep line through a needle is inside for the needle's width", "[geometry][shape]") {
  const Cylinder needle{.height = 1.0, .radius_top = 1e-9, .radius_bottom = 1e-9};
  const Crossings out = crossings(needle, {.origin{0.0, 0.4, 0.0}, .direction{1e-3, 1.0, 0.0}});
  REQUIRE(out.size() == 2);
  CHECK(out[1].t - out[0].t == Approx(2e-6).epsilon(1e-8));
}

TEST_CASE("a normal on the wrong side of a grazing line is turned to it", "[geometry][shape]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 direction = dice.direction() * dice.scale();
      const glm::dvec3 across = glm::normalize(glm::cross(direction, dice.direction()));
      const double off = std::pow(10.0, dice.between(-18.0, -6.0));
      const glm::dvec3 normal = across + off * glm::normalize(direction);
      const glm::dvec3 in = facing(normal, direction, true);
      RC_ASSERT(glm::dot(in, direction) <= 0.0);
      RC_ASSERT(glm::distance(in, across) < 1e-14 + off);
      RC_ASSERT(glm::dot(facing(-normal, direction, false), direction) >= 0.0);
      RC_ASSERT((facing(normal, -direction, true) == normal || glm::dot(normal, direction) < 0.0));
    }
  }));
}

TEST_CASE("crossings are appended to what is there", "[geometry][shape]") {
  Crossings out{{.t = 7.0}};
  const auto shape =
      GENERATE(Shape(Sphere{}), Shape(Box{}), Shape(Cylinder{}), Shape(Capsule{}), Shape(Torus{}));
  cross(shape, {.origin{0.01, 0.02, 0.0}, .direction{1.0, 0.0, 0.0}}, out);
  CHECK(out.size() == (std::holds_alternative<Torus>(shape) ? 5 : 3));
  CHECK(out[0] == Crossing{.t = 7.0});
}

TEST_CASE("bounds are exact and hold every crossing", "[geometry][shape]") {
  CHECK(bounds(Sphere{2.0}) == Bounds{.min = glm::dvec3(-2.0), .max = glm::dvec3(2.0)});
  CHECK(bounds(Box{{2.0, 4.0, 6.0}}) == Bounds{.min{-1.0, -2.0, -3.0}, .max{1.0, 2.0, 3.0}});
  CHECK(bounds(Cylinder{2.0, 0.0, 3.0}) == Bounds{.min{-3.0, -1.0, -3.0}, .max{3.0, 1.0, 3.0}});
  CHECK(bounds(Capsule{2.0, 0.5, 1.0}) == Bounds{.min{-1.0, -2.0, -1.0}, .max{1.0, 1.5, 1.0}});
  CHECK(bounds(Capsule{1.0, 0.5, 4.0}) == Bounds{.min{-4.0, -4.5, -4.0}, .max{4.0, 3.5, 4.0}});
  CHECK(bounds(Torus{2.0, 0.5}) == Bounds{.min{-2.5, -0.5, -2.5}, .max{2.5, 0.5, 2.5}});
  CHECK(bounds(HalfSpace{}) == Bounds{.min = glm::dvec3(-infinity), .max{infinity, 0.0, infinity}});
  CHECK(rc::check("every crossing", [] {
    Dice dice;
    const Shape shape = dice.below(2) == 0 ? Shape(any_cylinder(dice)) : Shape(any_capsule(dice));
    const Bounds box = bounds(shape);
    const double slack = 1e-12 * size_of(shape);
    for (int i = 0; i < 50; ++i) {
      const Ray ray = dice.line(size_of(shape));
      Crossings out;
      cross(shape, ray, out);
      for (const Crossing& crossing : out) {
        const glm::dvec3 point = ray.at(crossing.t);
        RC_ASSERT(glm::all(glm::greaterThan(point, box.min - slack)));
        RC_ASSERT(glm::all(glm::lessThan(point, box.max + slack)));
      }
    }
  }));
}

TEST_CASE("faces are counted without the caps that are points", "[geometry][shape]") {
  CHECK(face_count(Sphere{}) == 1);
  CHECK(face_count(Box{}) == 6);
  CHECK(face_count(Cylinder{}) == 3);
  CHECK(face_count(Cylinder{1.0, 0.0, 1.0}) == 2);
  CHECK(face_count(Cylinder{1.0, 1.0, 0.0}) == 2);
  CHECK(face_count(Capsule{}) == 1);
  CHECK(face_count(HalfSpace{}) == 1);
  CHECK(face_count(Torus{}) == 1);
}

TEST_CASE("shapes without volume are refused by the parameter's name", "[geometry][shape]") {
  CHECK_THROWS_WITH(validate(Sphere{-1.0}), "radius must be a finite number above 0, but is -1");
  CHECK_THROWS_WITH(validate(Sphere{infinity}),
                    "radius must be a finite number above 0, but is inf");
  CHECK_THROWS_AS(validate(Sphere{std::nan("")}), std::invalid_argument);
  CHECK_THROWS_WITH(validate(Box{{1.0, 0.0, 1.0}}),
                    "size.y must be a finite number above 0, but is 0");
  CHECK_THROWS_WITH(validate(Cylinder{0.0, 1.0, 1.0}),
                    "height must be a finite number above 0, but is 0");
  CHECK_THROWS_WITH(validate(Cylinder{1.0, -0.5, 1.0}),
                    "radiusTop must be a finite number not below 0, but is -0.5");
  CHECK_THROWS_WITH(validate(Cylinder{1.0, 0.0, 0.0}),
                    "radiusTop and radiusBottom must not both be 0");
  CHECK_THROWS_WITH(validate(Capsule{-1.0, 1.0, 1.0}),
                    "height must be a finite number not below 0, but is -1");
  CHECK_THROWS_WITH(validate(Torus{1.0, 0.0}), "tube must be a finite number above 0, but is 0");
  CHECK_THROWS_WITH(validate(MeshShape{}), "mesh must not be null");
  CHECK_NOTHROW(validate(Capsule{0.0, 0.0, 1.0}));
  CHECK_NOTHROW(validate(Cylinder{1e-6, 0.0, 1e6}));
  CHECK_NOTHROW(validate(HalfSpace{}));
}

}  // namespace
}  // namespace raycat
