#include "modelling/facet_rule.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace raycat {

std::uint32_t facet_count(double radius, const FacetRule& rule) {
  constexpr std::uint32_t most_corners = 1'000'000;
  constexpr double grid = 1.0 / (1 << 20);  // OpenSCAD's, on which smaller circles vanish
  if (radius < grid) {
    return 3;
  }
  constexpr double least = 0.01;
  const double by_angle = 360.0 / std::max(rule.angle, least);
  const double by_size = 2.0 * std::numbers::pi * radius / std::max(rule.size, least);
  const double count = rule.number > 0.0  // $fn is cut, as OpenSCAD 2021.01 does it
                           ? std::floor(std::max(rule.number, 3.0))
                           : std::ceil(std::max(std::min(by_angle, by_size), 5.0));
  if (!(count <= most_corners)) {
    throw std::length_error(
        fmt::format("circles have at most {} corners, but this has {:g}", most_corners, count));
  }
  return static_cast<std::uint32_t>(count);
}

glm::dvec2 unit_vector(double degrees) {
  if (degrees < 0.0 || degrees > 360.0) {
    const double rest = std::fmod(degrees, 360.0);
    return unit_vector(rest < 0.0 ? rest + 360.0 : rest);
  }
  if (degrees > 180.0) {
    const glm::dvec2 mirrored = unit_vector(360.0 - degrees);
    return {mirrored.x, -mirrored.y};
  }
  if (degrees > 90.0) {
    const glm::dvec2 mirrored = unit_vector(180.0 - degrees);
    return {-mirrored.x, mirrored.y};
  }
  if (degrees > 45.0) {
    const glm::dvec2 mirrored = unit_vector(90.0 - degrees);
    return {mirrored.y, mirrored.x};
  }
  if (degrees == 45.0) {
    return glm::dvec2(0.5 * std::numbers::sqrt2);
  }
  if (degrees == 30.0) {
    return {0.5 * std::numbers::sqrt3, 0.5};
  }
  const double radians = glm::radians(degrees);
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace raycat
