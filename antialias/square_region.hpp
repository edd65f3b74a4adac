#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "antialias/colour_distance.hpp"
#include "antialias/sampler.hpp"

namespace raycat {

/// A convex part of a square, in units of the square's side, with a value at each corner.
struct SquareRegion {
  std::array<glm::vec2, 5> points{};
  std::array<glm::vec4, 5> values{};
  int size = 0;
  int label = 0;

  void add(const glm::vec2& point, const glm::vec4& value);
};

/// Calls `visit(i, area)` for the triangles of a convex polygon's fan: its corners 0, i and i + 1.
template <typename Visit>
void for_each_triangle(std::span<const glm::vec2> polygon, const Visit& visit) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::vec2 u = polygon[i] - polygon[0];
    const glm::vec2 v = polygon[i + 1] - polygon[0];
    visit(i, 0.5f * std::abs(u.x * v.y - u.y * v.x));
  }
}

/// Of a region, its values interpolated in the triangles of a fan.
struct RegionIntegral {
  float area = 0.0f;
  glm::vec2 centre{0.0f};
  glm::vec4 mean{0.0f};
};
RegionIntegral integral(const SquareRegion& region);

/// What samples of one surface show of it.
struct SurfaceFit {
  using Plane = std::array<glm::vec4, 3>;  ///< value, and its change along x and y

  std::optional<Plane> plane;  ///< that fits them best, if they tell one
  float range = 0.0f;          ///< how far their colours are apart at most
  glm::vec4 mean{0.0f};

  glm::vec4 at(const glm::vec2& point) const {
    return plane ? (*plane)[0] + point.x * (*plane)[1] + point.y * (*plane)[2] : mean;
  }
};
SurfaceFit fit(std::span<const std::pair<glm::vec2, glm::vec4>> samples);

}  // namespace raycat
