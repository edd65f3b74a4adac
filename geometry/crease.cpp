#include "geometry/crease.hpp"

#include <limits>

#include <glm/common.hpp>

namespace raycat {

// A corner that moves by d out of the plane turns it by d over the height of that corner; the sum
// over three corners is d times the sum of the sides over twice the area.
double rounding_tilt(const std::array<glm::dvec3, 3>& corners) {
  constexpr double rounding = 0.5 * std::numeric_limits<float>::epsilon();
  const auto& [a, b, c] = corners;
  const double moved =
      rounding * glm::length(glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c)));
  const double sides = glm::length(b - a) + glm::length(c - b) + glm::length(a - c);
  return moved * sides / glm::length(glm::cross(b - a, c - a));
}

}  // namespace raycat
