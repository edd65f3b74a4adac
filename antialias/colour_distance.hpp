#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// How far two linear colours are apart: the root of the mean square over channels.
inline float distance_of(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = a - b;
  return std::sqrt(glm::dot(d, d) / 3.0f);
}

}  // namespace raycat
