#include <algorithm>
#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "geometry/shape.hpp"
#include "tests/geometry/lines.hpp"

namespace raycat {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

// The torus as the surface at distance `tube` from a circle, and a line, in fifty digits: no
// quartic in it.
class Reference {
 public:
  Reference(const Torus& torus, const Ray& ray) : torus_(torus), ray_(ray) {}

  /// Above 0 outside. In lengths.
  Exact operator()(const Exact& t) const {
    const Exact x = ray_.origin.x + t * ray_.direction.x;
    const Exact y = ray_.origin.y + t * ray_.direction.y;
    const Exact z = ray_.origin.z + t * ray_.direction.z;
    const Exact across = sqrt(x * x + z * z) - torus_.radius;
    return sqrt(across * across + y * y) - torus_.tube;
  }

  /// Whether the sign changes within `t` plus or minus `error`.
  bool changes_near(double t, double error) const {
    return ((*this)(Exact(t) - error) > 0) != ((*this)(Exact(t) + error) > 0);
  }

 private:
  Torus torus_;
  Ray ray_;
};

struct Line {
  Ray ray;
  double watch = 0.0;  ///< a t at which to ask for the side, if it is to be told at all
};

// Checks each crossing to 1e-9 of the torus, and by samples that none is missing.
void agrees_with_reference(const Torus& torus, const Line& line, Dice& dice) {
  const Ray& ray = line.ray;
  const Reference outside(torus, ray);
  const double size = torus.radius + torus.tube;
  const double length = glm::length(ray.direction);
  Crossings out;
  RC_ASSERT(!cross(torus, ray, out));
  RC_ASSERT(out.size() % 2 == 0U);
  require_in_turn(ray, out, false);
  const double middle = -glm::dot(ray.origin, ray.direction) / (length * length);
  const double error = 1e-9 * (size / length + std::abs(middle));
  for (const Crossing& crossing : out) {
    // Two crossings closer than the error are each other's neighbours: look less far.
    double room = error;
    for (const Crossing& other : out) {
      if (other.t != crossing.t) {
        room = std::min(room, 0.5 * std::abs(other.t - crossing.t));
      }
    }
    RC_ASSERT(outside.changes_near(crossing.t, room));
  }
  for (int sample = 0; sample < 20; ++sample) {
    const double t = sample == 0 ? line.watch : middle + dice.between(-1.1, 1.1) * size / length;
    const Exact distance = outside(t);
    if (abs(distance) > (sample == 0 ? 1e-15 : 1e-13) * size) {
      RC_ASSERT(inside_at(t, out, false) == (distance < 0));
    }
  }
}

Torus ring(Dice& dice) {
  const double size = dice.scale();
  return {.radius = size, .tube = size * dice.between(0.01, 0.99)};
}

Torus spindle(Dice& dice) {
  const double size = dice.scale();
  return {.radius = size * std::pow(10.0, dice.between(-3.0, 0.0)), .tube = size};
}

// A line that is tangent at a random point of the surface but for `depth` tubes towards its inside.
Line grazing(const Torus& torus, double depth, Dice& dice) {
  const double around = dice.between(-3.2, 3.2);
  const double about = dice.between(-3.2, 3.2);
  const glm::dvec3 spoke(std::cos(around), 0.0, std::sin(around));
  const glm::dvec3 normal = std::cos(about) * spoke + std::sin(about) * glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 point = torus.radius * spoke + torus.tube * (1.0 - depth) * normal;
  const glm::dvec3 any = dice.direction();
  const glm::dvec3 direction = glm::normalize(any - glm::dot(any, normal) * normal);
  const double scale = dice.scale();
  const double t = torus.radius * dice.between(-3.0, 3.0) / scale;
  return {.ray{.origin = point - direction * scale * t, .direction = direction * scale},
          .watch = t};
}

TEST_CASE("random lines cross a ring where fifty digits say", "[geometry][torus]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 20; ++i) {
      const Torus torus = ring(dice);
      agrees_with_reference(torus, {.ray = dice.line(torus.radius)}, dice);
    }
  }));
}

TEST_CASE("random lines cross a spindle where fifty digits say", "[geometry][torus]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 20; ++i) {
      const Torus torus = spindle(dice);
      agrees_with_reference(torus, {.ray = dice.line(torus.tube)}, dice);
    }
  }));
}

TEST_CASE("grazing lines cross a torus where fifty digits say", "[geometry][torus]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 20; ++i) {
      const Torus torus = dice.below(4) == 0 ? spindle(dice) : ring(dice);
      const double depth = std::pow(10.0, dice.between(-12.0, -3.0));
      agrees_with_reference(torus, grazing(torus, dice.below(2) == 0 ? depth : -depth, dice), dice);
    }
  }));
}

TEST_CASE("a line that grazes the outer equator by 1e-12 has a chord", "[geometry][torus]") {
  const auto size = GENERATE(1e-6, 1.0, 1e6);
  const Torus torus{.radius = 0.75 * size, .tube = 0.25 * size};
  Crossings out;
  cross(torus, {.origin{-2.0 * size, 0.0, size * (1.0 - 1e-12)}, .direction{1.0, 0.0, 0.0}}, out);
  REQUIRE(out.size() == 2);
  CHECK(out[1].t - out[0].t == Approx(2.0 * size * std::sqrt(2e-12)).epsilon(1e-3));
  out.clear();
  cross(torus, {.origin{-2.0 * size, 0.0, size * (1.0 + 1e-12)}, .direction{1.0, 0.0, 0.0}}, out);
  CHECK(out.empty());
}

TEST_CASE("a torus is crossed four times through its middle", "[geometry][torus]") {
  Crossings out;
  cross(Torus{.radius = 2.0, .tube = 0.5}, {.origin = glm::dvec3(0.0), .direction{0.5, 0.0, 0.0}},
        out);
  REQUIRE(out.size() == 4);
  CHECK(out[0].t == Approx(-5.0).epsilon(1e-15));
  CHECK(out[1].t == Approx(-3.0).epsilon(1e-15));
  CHECK(out[2].t == Approx(3.0).epsilon(1e-15));
  CHECK(out[3].t == Approx(5.0).epsilon(1e-15));
  CHECK(glm::normalize(out[1].normal) == glm::dvec3(1.0, 0.0, 0.0));
  CHECK(glm::normalize(out[3].normal) == glm::dvec3(1.0, 0.0, 0.0));
}

TEST_CASE("a line along the axis passes a ring and pierces a spindle", "[geometry][torus]") {
  const auto offset = GENERATE(0.0, 1e-300, 1e-15, 1e-12, 1e-9);
  const Ray along{.origin{offset, -7.0, 0.0}, .direction{0.0, 1.0, 0.0}};
  Crossings out;
  cross(Torus{.radius = 2.0, .tube = 0.5}, along, out);
  CHECK(out.empty());
  cross(Torus{.radius = 3.0, .tube = 5.0}, along, out);
  REQUIRE(out.size() == 2);
  CHECK(out[0].t == Approx(3.0).margin(2e-9));
  CHECK(out[1].t == Approx(11.0).margin(2e-9));
}

TEST_CASE("the lens inside a spindle is no boundary", "[geometry][torus]") {
  Crossings out;
  cross(Torus{.radius = 1.0, .tube = 2.0}, {.origin = glm::dvec3(0.0), .direction{1.0, 0.0, 0.0}},
        out);
  REQUIRE(out.size() == 2);
  CHECK(out[0].t == Approx(-3.0).epsilon(1e-15));
  CHECK(out[1].t == Approx(3.0).epsilon(1e-15));
}

TEST_CASE("a spindle has a dimple at its poles", "[geometry][torus]") {
  Crossings out;
  cross(Torus{.radius = 3.0, .tube = 5.0}, {.origin{0.0, 4.5, 0.0}, .direction{1.0, 0.0, 0.0}},
        out);
  REQUIRE(out.size() == 4);
  const double half = std::sqrt(25.0 - 4.5 * 4.5);
  CHECK(out[0].t == Approx(-3.0 - half).epsilon(1e-14));
  CHECK(out[1].t == Approx(half - 3.0).epsilon(1e-14));
  CHECK(out[2].t == Approx(3.0 - half).epsilon(1e-14));
}

TEST_CASE("a line in the plane that a torus lies on does not cross it", "[geometry][torus]") {
  Crossings out;
  const Ray on_top{.origin{-9.0, 0.5, 0.0}, .direction{1.0, 0.0, 0.0}};
  cross(Torus{.radius = 2.0, .tube = 0.5}, on_top, out);
  CHECK(out.empty());
}

}  // namespace
}  // namespace raycat
