#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace raycat {

/// An axis-aligned box. Empty when made; infinite sides are allowed.
struct Bounds {
  glm::dvec3 min{std::numeric_limits<double>::infinity()};
  glm::dvec3 max{-std::numeric_limits<double>::infinity()};

  bool empty() const noexcept { return glm::any(glm::greaterThan(min, max)); }

  bool finite() const noexcept {
    constexpr double most = std::numeric_limits<double>::max();
    return glm::all(glm::greaterThanEqual(min, glm::dvec3(-most))) &&
           glm::all(glm::lessThanEqual(max, glm::dvec3(most)));
  }

  glm::dvec3 center() const noexcept { return 0.5 * (min + max); }
  glm::dvec3 half_size() const noexcept { return 0.5 * (max - min); }

  void include(const glm::dvec3& point) noexcept {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }

  void include(const Bounds& other) noexcept {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }

  bool operator==(const Bounds&) const = default;
};

/// What both boxes cover.
inline Bounds intersection(const Bounds& a, const Bounds& b) noexcept {
  return {.min = glm::max(a.min, b.min), .max = glm::min(a.max, b.max)};
}

}  // namespace raycat
