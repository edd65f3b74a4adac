#include "modelling/sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace raycat {
namespace {

// Boxes are found by a line that is rounded, so that they are a little larger than the triangles.
constexpr double box_margin = 1e-12;  // of the largest coordinate

std::vector<Bounds> boxes(std::span<const Exact::Point_3> points,
                          std::span<const glm::uvec3> triangles) {
  double largest = 0.0;
  for (const Exact::Point_3& point : points) {
    const glm::dvec3 p = rounded(point);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  std::vector<Bounds> out(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      out[i].include(rounded(points[triangles[i][k]]));
    }
    out[i].min -= box_margin * largest;
    out[i].max += box_margin * largest;
  }
  return out;
}

// Points spread over a ball, always the same ones.
glm::dvec3 nudge(int attempt) {
  const auto part = [&](double step) { return std::fmod((attempt + 1) * step, 1.0) - 0.5; };
  return {part(0.8191725134), part(0.6710436067), part(0.5497004779)};
}

}  // namespace

Sides::Sides(std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
             std::span<const std::uint8_t> wanted)
    : points_(points), triangles_(triangles), wanted_(wanted), index_(boxes(points, triangles)) {}

void Sides::pass(const Exact::Point_3& point, glm::dvec3 direction,
                 std::vector<Passage>& out) const {
  const double length = glm::length(direction);
  direction = length > 0.0 ? direction / length : glm::dvec3(1.0, 0.0, 0.0);
  constexpr int most_attempts = 10000;  // of which the first nearly always does
  for (int attempt = 0; !try_pass(point, direction + 0.5 * nudge(attempt), out); ++attempt) {
    if (attempt == most_attempts) {
      throw std::runtime_error("a CSG tree could not be evaluated: no line is clear of all edges");
    }
  }
}

bool Sides::try_pass(const Exact::Point_3& point, const glm::dvec3& direction,
                     std::vector<Passage>& out) const {
  out.clear();
  const glm::dvec3 near = rounded(point);
  const Exact::Point_3 ahead = point + Exact::Vector_3(direction.x, direction.y, direction.z);
  bool clear = true;
  index_.visit({.origin = near, .direction = direction}, [&](std::uint32_t triangle) {
    if (!clear) {
      return;
    }
    const glm::uvec3& t = triangles_[triangle];
    const Exact::Point_3& a = points_[t.x];
    const Exact::Point_3& b = points_[t.y];
    const Exact::Point_3& c = points_[t.z];
    const CGAL::Orientation ab = CGAL::orientation(point, ahead, a, b);
    const CGAL::Orientation bc = CGAL::orientation(point, ahead, b, c);
    const CGAL::Orientation ca = CGAL::orientation(point, ahead, c, a);
    const bool positive = ab == CGAL::POSITIVE || bc == CGAL::POSITIVE || ca == CGAL::POSITIVE;
    const bool negative = ab == CGAL::NEGATIVE || bc == CGAL::NEGATIVE || ca == CGAL::NEGATIVE;
    if (positive && negative) {
      return;
    }
    const CGAL::Orientation side = CGAL::orientation(a, b, c, point);
    if (side == CGAL::ZERO && wanted_[triangle] == 0) {
      return;
    }
    if (ab == CGAL::ZERO || bc == CGAL::ZERO || ca == CGAL::ZERO) {
      clear = CGAL::collinear(a, b, c);
      return;
    }
    // The front is where the corners are seen counter-clockwise.
    const bool leaving = positive;
    if (side == CGAL::ZERO || (side == CGAL::NEGATIVE) == leaving) {
      out.push_back({.triangle = triangle, .here = side == CGAL::ZERO, .leaving = leaving});
    }
  });
  return clear;
}

}  // namespace raycat
