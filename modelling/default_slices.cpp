#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "modelling/extrusion.hpp"

namespace raycat {
namespace {

constexpr double grid = 1.0 / (1 << 20);  // OpenSCAD's, on which smaller things are points
constexpr double least_rule = 0.01;

// The greatest length of what `vector` gives for the corners.
template <typename Vector>
double longest(const Polygons& polygons, Vector vector) {
  double most = 0.0;
  for (const Contour& contour : polygons.contours) {
    for (const glm::dvec2& corner : contour) {
      most = std::max(most, glm::length(vector(corner)));
    }
  }
  return most;
}

// Of the spiral of Archimedes whose radius is its angle, from the centre.
double spiral_length(double angle) {
  return 0.5 * (angle * std::hypot(1.0, angle) + std::asinh(angle));
}

// Of the curve that a point at `radius` follows while it turns by `angle` and its distance from
// the axis grows to `scale` times that.
double flat_length(double radius, double angle, double scale) {
  if (scale == 1.0) {
    return radius * angle;
  }
  const double end = scale > 1.0 ? angle * scale / (scale - 1.0) : angle / (1.0 - scale);
  return radius / end * (spiral_length(end) - spiral_length(end - angle));
}

double twist_slices(double radius, double scale, const LinearExtrusion& extrusion,
                    const FacetRule& rule) {
  const double twist = std::abs(extrusion.twist);
  const double least = std::max(std::ceil(twist / 120.0), 1.0);
  if (radius < grid) {
    return least;
  }
  if (rule.number > 0.0) {
    return std::max(std::ceil(twist / 360.0 * rule.number), least);
  }
  const double length =
      std::hypot(flat_length(radius, glm::radians(twist), scale), extrusion.height);
  const double by_angle = std::ceil(twist / std::max(rule.angle, least_rule));
  const double by_size = std::ceil(length / std::max(rule.size, least_rule));
  return std::max(std::min(by_angle, by_size), least);
}

// Walls that are not flat, since one axis is scaled more than the other.
double shear_slices(const Polygons& polygons, const LinearExtrusion& extrusion,
                    const FacetRule& rule) {
  const double move = longest(
      polygons, [&](const glm::dvec2& corner) { return corner - extrusion.scale * corner; });
  if (move < grid) {
    return 1.0;
  }
  if (rule.number > 0.0) {
    return std::ceil(rule.number);
  }
  return std::ceil(std::hypot(move, extrusion.height) / std::max(rule.size, least_rule));
}

}  // namespace

std::uint32_t default_slices(const Polygons& polygons, const LinearExtrusion& extrusion,
                             const FacetRule& rule) {
  constexpr std::uint32_t most = 1'000'000;
  double slices = 1.0;
  const bool even = extrusion.scale.x == extrusion.scale.y;
  if (extrusion.twist != 0.0) {
    const double radius = longest(polygons, [](const glm::dvec2& corner) { return corner; });
    slices = twist_slices(radius, even ? extrusion.scale.x : 1.0, extrusion, rule);
  } else if (!even) {
    slices = shear_slices(polygons, extrusion, rule);
  }
  if (!(slices <= most)) {
    throw std::length_error(
        fmt::format("a linear extrusion has at most {} slices, but this has {:g}", most, slices));
  }
  return static_cast<std::uint32_t>(slices);
}

}  // namespace raycat
