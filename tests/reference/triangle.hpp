#pragma once

#include <algorithm>
#include <optional>

#include "reference/line.hpp"

namespace raycat::reference {

/// Where a line meets a triangle.
struct TriangleHit {
  Real t = 0.0L;
  Real v = 0.0L, w = 0.0L;  ///< barycentric, of the second and third corner
  bool entering = false;    ///< against the normal, to which the corners run counter-clockwise
  Real to_edge = 0.0L;      ///< the least of the three barycentric coordinates
};

/// Edges belong to the triangle, with a hair beyond them, so that no line slips between two.
inline std::optional<TriangleHit> meet(const Line& line, const Vec& a, const Vec& b, const Vec& c) {
  const Vec normal = glm::cross(b - a, c - a);
  const Real against = glm::dot(normal, line.direction);
  if (against == 0.0L) {
    return std::nullopt;
  }
  const Vec to_a = a - line.origin;
  const Vec turned = glm::cross(to_a, line.direction);
  const Real v = glm::dot(c - a, turned) / against;
  const Real w = glm::dot(b - a, turned) / -against;
  const Real least = std::min({v, w, 1.0L - v - w});
  if (least < -1e-15L) {
    return std::nullopt;
  }
  return TriangleHit{.t = glm::dot(normal, to_a) / against,
                     .v = v,
                     .w = w,
                     .entering = against < 0.0L,
                     .to_edge = least};
}

}  // namespace raycat::reference
