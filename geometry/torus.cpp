#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/facing.hpp"
#include "geometry/quartic.hpp"
#include "geometry/shape.hpp"

namespace raycat {
namespace {

// Extended precision throughout: on x86 a Horner step takes as long as in double, and a line that
// grazes the torus at 1e-12 of its size is still told from one that misses it.
using Real = long double;
using Vec = glm::vec<3, Real>;

/// A line `near + s * direction` and a torus around Y, in units in which the direction and the
/// outer radius of the torus are 1. `near` is the line's point closest to the centre.
struct Setting {
  Vec near;
  Vec direction;
  Real radius;
  Real tube;
};

struct Interval {
  Real lower;
  Real upper;
};

// The line's part in the ball and the slab around the torus, which end a little outside of it so
// that the line's ends are too. Empty if lower is not below upper.
Interval neighbourhood(const Setting& in) noexcept {
  constexpr Real margin = 1.0001L;
  const Real half = std::sqrt(margin - glm::dot(in.near, in.near));
  Interval result{.lower = -half, .upper = half};
  if (in.direction.y == 0.0L) {
    return std::abs(in.near.y) < in.tube ? result : Interval{.lower = 0.0L, .upper = 0.0L};
  }
  const Real middle = -in.near.y / in.direction.y;
  const Real reach = std::abs(margin * in.tube / in.direction.y);
  result.lower = std::max(result.lower, middle - reach);
  result.upper = std::min(result.upper, middle + reach);
  return result;
}

/// Crossings ascend, and enter and leave in turn, from outside.
Roots boundary(const Setting& in) noexcept {
  const Interval around = neighbourhood(in);
  if (!(around.lower < around.upper)) {
    return {};
  }
  // With k = |q|^2 + R^2 - r^2 at the point q and its distance w from the axis, q is inside where
  // k < 2 R w, and the quartic k^2 - (2 R w)^2 is negative there as long as k >= 0.
  const Vec& p = in.near;
  const Vec& d = in.direction;
  const Real b = glm::dot(p, d);
  const Real k = glm::dot(p, p) + (in.radius - in.tube) * (in.radius + in.tube);
  const Real r4 = 4.0L * in.radius * in.radius;
  const Quartic quartic{k * k - r4 * (p.x * p.x + p.z * p.z),
                        4.0L * b * k - 2.0L * r4 * (p.x * d.x + p.z * d.z),
                        4.0L * b * b + 2.0L * k - r4 * (d.x * d.x + d.z * d.z), 4.0L * b, 1.0L};
  const RootBound lower{.x = around.lower, .negative = false};
  const RootBound upper{.x = around.upper, .negative = false};
  const Real discriminant = b * b - k;
  if (discriminant <= 0.0L) {
    return sign_changes(quartic, lower, upper);
  }
  // k < 0 only inside a spindle, around its lens, whose own surface the quartic has as roots too.
  // Lines near the axis touch both surfaces at once, so the sign is set here, not computed.
  const Real half = std::sqrt(discriminant);
  Roots roots = sign_changes(quartic, lower, {.x = -b - half, .negative = true});
  for (const Real s : sign_changes(quartic, {.x = -b + half, .negative = true}, upper)) {
    roots.push_back(s);
  }
  return roots;
}

glm::dvec3 normal(const Setting& in, const glm::dvec3& point) noexcept {
  const double from_axis = std::sqrt(point.x * point.x + point.z * point.z);
  const double from_tube = from_axis - static_cast<double>(in.radius);
  return from_axis > 0.0 ? glm::dvec3(point.x * from_tube, point.y * from_axis, point.z * from_tube)
                         : glm::dvec3(0.0, point.y, 0.0);  // the pole of a spindle has many normals
}

}  // namespace

bool cross(const Torus& torus, const Ray& ray, Crossings& out) {
  const Vec origin(ray.origin);
  const Vec direction(ray.direction);
  const Real squared = glm::dot(direction, direction);
  const Real nearest = -glm::dot(origin, direction) / squared;
  const Vec near = origin + nearest * direction;
  const Real size = static_cast<Real>(torus.radius) + torus.tube;
  if (glm::dot(near, near) >= size * size) {
    return false;
  }
  const Real length = std::sqrt(squared);
  const Setting in{.near = near / size,
                   .direction = direction / length,
                   .radius = torus.radius / size,
                   .tube = torus.tube / size};
  const std::size_t first = out.size();
  bool entering = true;
  for (const Real s : boundary(in)) {
    const auto t = static_cast<double>(nearest + s * size / length);
    if (out.size() > first && !(out.back().t < t)) {
      out.pop_back();  // in and out again, or out and in, within the precision of t: a touch
    } else {
      const glm::dvec3 outward = normal(in, glm::dvec3(in.near + s * in.direction));
      out.push_back(
          {.t = t, .normal = facing(outward, ray.direction, entering), .entering = entering});
    }
    entering = !entering;
  }
  return false;
}

}  // namespace raycat
