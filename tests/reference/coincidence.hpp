#pragma once

#include <cmath>

#include "reference/line.hpp"

namespace raycat::reference {

/// What part of a scene's or tree's half diagonal surfaces may lie apart that are one.
inline constexpr Real coincident = 1e-7L;

/// Do two surfaces that a line of this direction passes at `t` and `other_t`, with these unit
/// normals, lie in one surface, up to a distance?
inline bool in_one_surface(const Vec& direction, Real t, const Vec& normal, Real other_t,
                           const Vec& other_normal, Real distance) {
  return std::abs((other_t - t) * glm::dot(direction, normal)) <= distance &&
         glm::length(glm::cross(normal, other_normal)) < 1e-5L;
}

}  // namespace raycat::reference
