#pragma once

#include <glm/vec3.hpp>

namespace raycat {

/// The points `origin + t * direction`. The direction has any length but zero; t counts in
/// units of it, so a ray keeps its t under every affine transform.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};

  glm::dvec3 at(double t) const noexcept { return origin + t * direction; }
};

}  // namespace raycat
