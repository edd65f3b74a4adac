#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/vec3.hpp>

#include "geometry/bounds.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// A part of a line, between two parameters.
struct Interval {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();

  bool empty() const noexcept { return !(begin <= end); }
};

/// Clips one line against many boxes. Boxes are closed: a line within a face is in the box. The
/// ends are exact to a few ulps of the distance from the line's origin to the box.
class LineClip {
 public:
  explicit LineClip(const Ray& ray) noexcept : origin_(ray.origin) {
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = 1.0 / ray.direction[axis];
      parallel_[axis] = !std::isfinite(inverse);
      inverse_[axis] = parallel_[axis] ? 0.0 : inverse;
    }
  }

  /// The part of `interval` that lies in `box`.
  Interval operator()(const Bounds& box, Interval interval = {}) const noexcept {
    for (int axis = 0; axis < 3; ++axis) {
      const double low = box.min[axis] - origin_[axis];
      const double high = box.max[axis] - origin_[axis];
      if (parallel_[axis]) {
        if (low > 0.0 || high < 0.0) {
          return {.begin = 1.0, .end = 0.0};
        }
        continue;
      }
      const double a = low * inverse_[axis];
      const double b = high * inverse_[axis];
      interval.begin = std::max(interval.begin, std::min(a, b));
      interval.end = std::min(interval.end, std::max(a, b));
    }
    return interval;
  }

 private:
  glm::dvec3 origin_;
  glm::dvec3 inverse_{0.0};
  glm::bvec3 parallel_{false};
};

}  // namespace raycat
