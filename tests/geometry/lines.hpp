#pragma once

#include <cmath>
#include <functional>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <rapidcheck.h>

#include "geometry/crossing.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// Plain random numbers for properties over many lines, from a seed that RapidCheck chooses.
class Dice {
 public:
  Dice() : engine_(*rc::gen::arbitrary<std::uint32_t>()) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  /// From 1e-6 to 1e6, all magnitudes alike.
  double scale() { return std::pow(10.0, between(-6.0, 6.0)); }

  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }

  glm::dvec3 in_box(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }

  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 v = in_box(1.0);
      const double length = glm::length(v);
      if (length > 0.1 && length < 1.0) {
        return v / length;
      }
    }
  }

  /// A line past the origin within `size`, with a direction of any length, which starts before,
  /// in or after what is there, as far as `away` sizes.
  Ray line(double size, double away = 5.0) {
    const glm::dvec3 way = direction();
    return {.origin = in_box(size) + way * size * between(-away, away), .direction = way * scale()};
  }

 private:
  std::mt19937 engine_;
};

/// Ascending, entering and leaving in turn from the side that `inside` says, normals facing.
inline void require_in_turn(const Ray& ray, const Crossings& crossings, bool inside) {
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    RC_ASSERT(std::isfinite(crossings[i].t));
    RC_ASSERT((i == 0 || crossings[i - 1].t < crossings[i].t));
    RC_ASSERT(crossings[i].entering != inside);
    inside = !inside;
    const double along = glm::dot(crossings[i].normal, ray.direction);
    RC_ASSERT((crossings[i].entering ? along <= 0.0 : along >= 0.0));
    RC_ASSERT(glm::length(crossings[i].normal) > 0.0);
  }
}

/// Is the line inside at t, by its crossings?
inline bool inside_at(double t, const Crossings& crossings, bool inside) {
  for (const Crossing& crossing : crossings) {
    inside = crossing.t < t ? crossing.entering : inside;
  }
  return inside;
}

/// Checks the crossings against `depth`, which is some measure in lengths, no larger than the
/// distance to the surface, that is positive inside: where it exceeds `tolerance` in magnitude, it
/// has to have the side that the crossings say.
inline void require_membership(const Ray& ray, const Crossings& crossings, bool inside,
                               const std::function<double(const glm::dvec3&)>& depth, double reach,
                               double tolerance, Dice& dice) {
  const double length = glm::length(ray.direction);
  const double middle = -glm::dot(ray.origin, ray.direction) / (length * length);
  for (int sample = 0; sample < 60; ++sample) {
    const double t = middle + dice.between(-reach, reach) / length;
    const double at = depth(ray.at(t));
    if (std::abs(at) > tolerance) {
      RC_ASSERT(inside_at(t, crossings, inside) == (at > 0.0));
    }
  }
  for (const Crossing& crossing : crossings) {
    RC_ASSERT(std::abs(depth(ray.at(crossing.t))) <= tolerance);
  }
}

}  // namespace raycat
