#pragma once

#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// `normal`, unless rounding has left it on the wrong side of a grazing line: then the nearest
/// one that is on the right side, so that `dot(normal, direction)` is never above 0 where the
/// line enters nor below 0 where it leaves.
inline glm::dvec3 facing(const glm::dvec3& normal, const glm::dvec3& direction, bool entering) {
  const double along = glm::dot(normal, direction);
  if (entering ? along <= 0.0 : along >= 0.0) {
    return normal;
  }
  // The part along the line goes, and a little more: the product of what is left with the
  // direction rounds to either sign.
  const double length = glm::length(direction);
  const double more = 8.0 * std::numeric_limits<double>::epsilon() * glm::length(normal);
  return normal - direction * (along / length + (entering ? more : -more)) / length;
}

}  // namespace raycat
