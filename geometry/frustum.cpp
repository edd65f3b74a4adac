#include "geometry/frustum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr FrustumSpan nothing{.in = infinity, .out = -infinity};

struct Interval {
  double in = infinity;
  double out = -infinity;
};

constexpr Interval everything{.in = -infinity, .out = infinity};

constexpr double square(double x) noexcept { return x * x; }

// The part of the line within the endless cone of `frustum`, or with its mirror image beyond the
// apex, from which the two heights keep clear. With the cone's radius r and its growth m along
// the line, a point is within where x^2 + z^2 - r^2 = a s^2 + 2 b s + c is negative.
Interval within_cone(const Frustum& frustum, const glm::dvec3& near,
                     const glm::dvec3& direction) noexcept {
  const double x = near.x;
  const double z = near.z;
  const double dx = direction.x;
  const double dz = direction.z;
  const double r = frustum.radius + frustum.slope * (near.y - frustum.middle);
  const double m = frustum.slope * direction.y;
  const double a = dx * dx + dz * dz - m * m;
  const double b = x * dx + z * dz - r * m;
  const double c = x * x + z * z - r * r;
  // b^2 - a c, multiplied out: the difference itself would cancel for lines along the axis.
  const double discriminant =
      square(x * m - r * dx) + square(z * m - r * dz) - square(x * dz - z * dx);
  if (a >= 0.0 && discriminant <= 0.0) {
    return a == 0.0 && c < 0.0 ? everything : Interval{};  // parallel to a cylinder, or outside
  }
  // A steep line pierces both cones, so its discriminant is below 0 only by rounding, at the
  // apex. For a = 0 the first root is the infinity on the right side.
  const double q = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  const auto [first, last] =
      q == 0.0 ? std::pair(0.0, 0.0) : std::pair(std::minmax({q / a, c / q}));
  if (a >= 0.0) {
    return {.in = first, .out = last};
  }
  return m > 0.0 ? Interval{.in = last, .out = infinity} : Interval{.in = -infinity, .out = first};
}

}  // namespace

glm::dvec3 Frustum::side_normal(const glm::dvec3& point) const noexcept {
  const double at_point = radius + slope * (point.y - middle);
  if (point.x == 0.0 && point.z == 0.0) {
    return {0.0, -slope, 0.0};  // the apex has many normals, and the axis is one
  }
  return {point.x, -slope * at_point, point.z};
}

FrustumSpan span(const Frustum& frustum, const glm::dvec3& near,
                 const glm::dvec3& direction) noexcept {
  FrustumSpan result{.in = -infinity, .out = infinity};
  const double y = near.y - frustum.middle;
  if (direction.y == 0.0) {
    if (y < -frustum.half_height || y >= frustum.half_height) {
      return nothing;
    }
  } else {
    const double bottom = (-frustum.half_height - y) / direction.y;
    const double top = (frustum.half_height - y) / direction.y;
    result = direction.y > 0.0 ? FrustumSpan{bottom, top, FrustumPart::bottom, FrustumPart::top}
                               : FrustumSpan{top, bottom, FrustumPart::top, FrustumPart::bottom};
  }
  const Interval cone = within_cone(frustum, near, direction);
  if (cone.in > result.in) {
    result.in = cone.in;
    result.in_part = FrustumPart::side;
  }
  if (cone.out < result.out) {
    result.out = cone.out;
    result.out_part = FrustumPart::side;
  }
  return result;
}

}  // namespace raycat
