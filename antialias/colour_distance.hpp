#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace raycat {

/// How much a difference of two linear colours with associated alpha counts: the mean square over
/// channels, over black or over white, whichever shows more.
inline float squared_magnitude(const glm::vec4& difference) {
  constexpr float third = 1.0f / 3.0f;
  const glm::vec3 over_black(difference);
  const float black = third * glm::dot(over_black, over_black);
  if (difference.a == 0.0f) {
    return black;
  }
  const glm::vec3 over_white = over_black - difference.a;
  return std::max(black, third * glm::dot(over_white, over_white));
}

/// The root of that.
inline float magnitude(const glm::vec4& difference) {
  return std::sqrt(squared_magnitude(difference));
}

/// How far two linear colours with associated alpha are apart.
inline float distance_of(const glm::vec4& a, const glm::vec4& b) { return magnitude(a - b); }

}  // namespace raycat
