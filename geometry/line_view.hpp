#pragma once

#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// The view along a line. A point is seen at (x, y) across and z along the line, which runs
/// through (0, 0) towards growing z; x, y, z is right-handed, skewed, and z counts in units of
/// the coordinate axis that the line follows most. What a point is seen as depends on the point
/// and the line alone, so that triangles that share vertices still do so in the view.
class LineView {
 public:
  LineView(const glm::dvec3& origin, const glm::dvec3& direction) : origin_(origin) {
    const glm::dvec3 size = glm::abs(direction);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (direction[z_] < 0.0) {
      std::swap(x_, y_);
    }
    step_ = direction[z_];
    shear_x_ = direction[x_] / step_;
    shear_y_ = direction[y_] / step_;
  }

  glm::dvec3 operator()(const glm::dvec3& point) const noexcept {
    const glm::dvec3 offset = point - origin_;
    const double z = offset[z_];
    return {settled(offset[x_] - shear_x_ * z), settled(offset[y_] - shear_y_ * z), z};
  }

  /// The ray parameter, from the view's origin on, of what is seen at `z`.
  double parameter(double z) const noexcept { return z / step_; }

 private:
  // Moves what is next to nothing onto the line, so that no product of two coordinates, nor its
  // rounding error, underflows and the predicates below stay exact.
  static double settled(double value) noexcept { return std::abs(value) < 1e-140 ? 0.0 : value; }

  glm::dvec3 origin_;
  double step_ = 1.0, shear_x_ = 0.0, shear_y_ = 0.0;
  int x_ = 0, y_ = 1, z_ = 2;
};

inline int sign_of_difference(double a, double b) noexcept {
  return static_cast<int>(a > b) - static_cast<int>(a < b);
}

/// On which side of the directed edge from `a` to `b` the line runs: 1 left, -1 right, exactly.
/// A line that meets the edge counts as if moved by (e, e²) for an infinitely small e, a move
/// that is the same for all edges. 0 only if `a` and `b` are seen at one place.
inline int side_of_line(const glm::dvec3& a, const glm::dvec3& b) noexcept {
  const double p = a.x * b.y;
  const double q = a.y * b.x;
  if (p != q) {  // rounding keeps the order of products that it keeps apart
    return p > q ? 1 : -1;
  }
  if (const int s = sign_of_difference(std::fma(a.x, b.y, -p), std::fma(a.y, b.x, -q)); s != 0) {
    return s;
  }
  // The move changes the difference of products by e (a.y - b.y) + e² (b.x - a.x).
  const int s = sign_of_difference(a.y, b.y);
  return s != 0 ? s : sign_of_difference(b.x, a.x);
}

/// Twice the area of the triangle from the line to `a` and `b`, with its sign, to about an ulp.
inline double area_at_line(const glm::dvec3& a, const glm::dvec3& b) noexcept {
  const double q = a.y * b.x;
  return std::fma(a.x, b.y, -q) - std::fma(a.y, b.x, -q);
}

}  // namespace raycat
