#include "geometry/placed_shape.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/geometry/lines.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Crossings crossings(const PlacedShape& shape, const Ray& ray) {
  Crossings out;
  shape.cross(ray, out);
  return out;
}

glm::dmat4 scaling(const glm::dvec3& factors) { return glm::scale(glm::dmat4(1.0), factors); }

// Turned, mirrored by half of them, sheared and stretched up to 10 times.
glm::dmat4 any_matrix(Dice& dice, double scale) {
  const auto turn = [&] {
    return glm::rotate(glm::dmat4(1.0), dice.between(-3.0, 3.0), dice.direction());
  };
  const double sign = dice.below(2) == 0 ? 1.0 : -1.0;
  const glm::dvec3 stretch(dice.between(0.3, 3.0), dice.between(0.3, 3.0),
                           sign * dice.between(0.3, 3.0));
  glm::dmat4 matrix = turn() * scaling(scale * stretch) * turn();
  matrix[3] = glm::dvec4(dice.in_box(10.0 * scale), 1.0);
  return matrix;
}

Shape any_shape(Dice& dice) {
  const Shape shapes[] = {Sphere{1.3},
                          Box{{1.0, 2.0, 1.5}},
                          Cylinder{1.5, 1.0, 1.0},
                          Cylinder{2.0, 0.0, 1.0},
                          Capsule{1.0, 0.3, 0.8},
                          HalfSpace{},
                          Torus{1.0, 0.4},
                          Torus{0.5, 0.8}};
  return shapes[dice.below(8)];
}

TEST_CASE("a shape placed anywhere is crossed as in its own frame", "[geometry][placed_shape]") {
  CHECK(rc::check([] {
    Dice dice;
    const double scale = dice.scale();
    const Shape shape = any_shape(dice);
    const Affine affine(any_matrix(dice, scale));
    const PlacedShape placed(shape, affine);
    for (int i = 0; i < 50; ++i) {
      const Ray local = dice.line(1.5);
      const glm::dvec3 start = affine.point(local.origin);
      const double stretch = std::pow(10.0, -std::round(std::log10(glm::length(local.direction))));
      const Ray world{.origin = start,
                      .direction = affine.point(local.origin + local.direction * stretch) - start};
      const Ray unit{.origin = local.origin, .direction = local.direction * stretch};
      Crossings here;
      const bool inside = placed.cross(world, here);
      Crossings there;
      const bool inside_there = cross(shape, unit, there);
      require_in_turn(world, here, inside);
      RC_ASSERT(inside == inside_there);
      if (here.size() != there.size()) {
        continue;  // one of them grazes
      }
      for (std::size_t k = 0; k < here.size(); ++k) {
        RC_ASSERT(std::abs(here[k].t - there[k].t) < 1e-5);
        RC_ASSERT(std::abs(glm::length(here[k].normal) - 1.0) < 1e-12);
      }
    }
  }));
}

// The normal of an affine image is checked against the image of two tangents.
TEST_CASE("normals stay perpendicular and outward, mirrored and sheared",
          "[geometry][placed_shape]") {
  CHECK(rc::check([] {
    Dice dice;
    const Affine affine(any_matrix(dice, dice.scale()));
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 local = dice.direction();
      const glm::dvec3 tangent = glm::cross(local, dice.direction());
      const glm::dvec3 normal = affine.normal(local * dice.scale());
      const auto image = [&](const glm::dvec3& v) {
        return glm::normalize(affine.point(v) - affine.point(glm::dvec3(0.0)));
      };
      RC_ASSERT(std::abs(glm::length(normal) - 1.0) < 1e-12);
      RC_ASSERT(std::abs(glm::dot(normal, image(tangent))) < 1e-11);
      RC_ASSERT(glm::dot(normal, image(local)) > 0.0);
    }
  }));
}

TEST_CASE("a stretched sphere is an ellipsoid", "[geometry][placed_shape]") {
  const PlacedShape ellipsoid(Sphere{1.0}, Affine(scaling({1.0, -2.0, 3.0})));
  CHECK(ellipsoid.transform().mirrored());
  const Crossings out = crossings(ellipsoid, {.origin{0.5, 0.0, 0.0}, .direction{0.0, 1.0, 0.0}});
  REQUIRE(out.size() == 2);
  CHECK(out[1].t == Approx(std::sqrt(3.0)).epsilon(1e-15));
  const glm::dvec3 gradient = glm::normalize(glm::dvec3(0.5, std::sqrt(3.0) / 4.0, 0.0));
  CHECK(out[1].normal.x == Approx(gradient.x).epsilon(1e-14));
  CHECK(out[1].normal.y == Approx(gradient.y).epsilon(1e-14));
  CHECK(ellipsoid.bounds() == Bounds{.min{-1.0, -2.0, -3.0}, .max{1.0, 2.0, 3.0}});
}

TEST_CASE("a sheared half-space keeps its side", "[geometry][placed_shape]") {
  glm::dmat4 shear(1.0);
  shear[0][1] = 1.0;  // y grows with x
  Crossings out;
  const PlacedShape slope(HalfSpace{}, Affine(shear));
  CHECK(slope.cross({.origin{2.0, 0.0, 0.0}, .direction{0.0, 1.0, 0.0}}, out));
  REQUIRE(out.size() == 1);
  CHECK(out[0].t == 2.0);
  CHECK(out[0].normal.x == Approx(-std::sqrt(0.5)));
  CHECK(out[0].normal.y == Approx(std::sqrt(0.5)));
}

TEST_CASE("a rigid motion of shape and line together changes no t", "[geometry][placed_shape]") {
  CHECK(rc::check([] {
    Dice dice;
    glm::dmat4 motion = glm::rotate(glm::dmat4(1.0), dice.between(-3.0, 3.0), dice.direction());
    motion[3] = glm::dvec4(dice.in_box(5.0), 1.0);
    const Affine affine(motion);
    const Shape shape = any_shape(dice);
    const PlacedShape moved(shape, affine);
    for (int i = 0; i < 50; ++i) {
      const Ray ray{.origin = dice.in_box(2.0), .direction = dice.direction()};
      Crossings still;
      cross(shape, ray, still);
      const Crossings out = crossings(
          moved, {.origin = affine.point(ray.origin),
                  .direction = affine.point(ray.direction) - affine.point(glm::dvec3(0.0))});
      if (out.size() != still.size()) {
        continue;  // grazes
      }
      for (std::size_t k = 0; k < out.size(); ++k) {
        // As far from the surface: along a line that nearly grazes it, t may move by more.
        const double slope = std::abs(glm::dot(glm::normalize(still[k].normal), ray.direction));
        RC_ASSERT(std::abs(out[k].t - still[k].t) * slope < 1e-8);
        RC_ASSERT(out[k].face == still[k].face);
      }
    }
  }));
}

TEST_CASE("world bounds hold every crossing", "[geometry][placed_shape]") {
  CHECK(rc::check([] {
    Dice dice;
    const double scale = dice.scale();
    const PlacedShape placed(any_shape(dice), Affine(any_matrix(dice, scale)));
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 target = placed.transform().point(dice.in_box(1.0));
      const Ray ray{.origin = target, .direction = dice.direction()};
      for (const Crossing& crossing : crossings(placed, ray)) {
        const glm::dvec3 point = ray.at(crossing.t);
        const double slack = 1e-11 * scale;
        RC_ASSERT(glm::all(glm::greaterThan(point, placed.bounds().min - slack)));
        RC_ASSERT(glm::all(glm::lessThan(point, placed.bounds().max + slack)));
      }
    }
  }));
}

TEST_CASE("an infinite box is infinite on every side, however placed", "[geometry][placed_shape]") {
  const Bounds everywhere{.min = glm::dvec3(-infinity), .max = glm::dvec3(infinity)};
  CHECK(PlacedShape(HalfSpace{}).bounds() == everywhere);
  CHECK(Affine(scaling(glm::dvec3(1e-6))).bounds(bounds(HalfSpace{})) == everywhere);
  CHECK(Affine().bounds({}).empty());
}

TEST_CASE("scales of 1e-6 and 1e6 are no reason to refuse a map", "[geometry][placed_shape]") {
  const auto factors =
      GENERATE(glm::dvec3(1e-6), glm::dvec3(1e6), glm::dvec3(1e-150), glm::dvec3(1e6, 1e-6, -1.0));
  const Affine affine(scaling(factors));
  CHECK(affine.matrix() == scaling(factors));
  CHECK(affine.to_local({.origin = factors}).origin.x == Approx(1.0));
}

TEST_CASE("a map without an inverse is refused", "[geometry][placed_shape]") {
  CHECK_THROWS_WITH(Affine(scaling({1.0, 0.0, 1.0})),
                    "transform must be invertible, but is singular");
  glm::dmat4 flat(1.0);
  flat[0] = {0.1, 0.2, 0.3, 0.0};
  flat[1] = {0.4, 0.5, 0.6, 0.0};
  flat[2] = {0.7, 0.8, 0.9, 0.0};
  CHECK_THROWS_WITH(Affine(flat), "transform must be invertible, but is singular");
}

TEST_CASE("a map that is not affine or not finite is refused", "[geometry][placed_shape]") {
  glm::dmat4 projective(1.0);
  projective[2][3] = -1.0;
  CHECK_THROWS_WITH(Affine(projective), "transform must have (0, 0, 0, 1) as its last row");
  CHECK_THROWS_WITH(Affine(glm::dmat4(2.0)), "transform must have (0, 0, 0, 1) as its last row");
  glm::dmat4 endless(1.0);
  endless[3][0] = infinity;
  CHECK_THROWS_WITH(Affine(endless), "transform must be of finite numbers");
  CHECK_THROWS_AS(Affine(scaling(glm::dvec3(std::nan("")))), std::invalid_argument);
}

TEST_CASE("placing a shape checks its parameters", "[geometry][placed_shape]") {
  CHECK_THROWS_WITH(PlacedShape(Sphere{0.0}), "radius must be a finite number above 0, but is 0");
}

}  // namespace
}  // namespace raycat
