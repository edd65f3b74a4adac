#include "tracer/extreme_search.hpp"

#include <cmath>
#include <limits>

namespace raycat {
namespace {

constexpr double last_step = 1e-6;
constexpr int most_steps = 200;
constexpr int directions = 6;
constexpr double golden_angle = 2.399963229728653;

// One side of the box.
class Climb {
 public:
  Climb(const Solid& solid, int side, Solid::Scratch& scratch)
      : solid_(solid), axis_(side / 2), upper_(side % 2 == 1), scratch_(scratch) {}

  double highest(const glm::dvec3& start, double step) const {
    const Bounds& box = solid_.bounds();
    const double limit = outward(upper_ ? box.max : box.min);
    const double size = 2.0 * box.half_size()[axis_];
    glm::dvec3 best = start;
    double height = outward(start);
    for (int i = 0; i < most_steps && step > last_step && limit - height > 1e-12 * size; ++i) {
      const glm::dvec3 from = best;
      for (int k = 0; k < directions; ++k) {
        // Turned each time, so that no ridge lies between the directions for long.
        const double angle = golden_angle * i + 6.283185307179586 * k / directions;
        glm::dvec3 next = from;
        next[(axis_ + 1) % 3] += step * std::cos(angle) * 2.0 * box.half_size()[(axis_ + 1) % 3];
        next[(axis_ + 2) % 3] += step * std::sin(angle) * 2.0 * box.half_size()[(axis_ + 2) % 3];
        if (const double found = height_at(next); found > height) {
          height = found;
          best = next;
        }
      }
      step *= best == from ? 0.5 : 1.0;
    }
    return upper_ ? height : -height;
  }

 private:
  double outward(const glm::dvec3& point) const { return upper_ ? point[axis_] : -point[axis_]; }

  // Of the surface on the line through the point.
  double height_at(const glm::dvec3& point) const {
    Ray ray{.origin = point, .direction = glm::dvec3(0.0)};
    ray.origin[axis_] = solid_.bounds().center()[axis_];
    ray.direction[axis_] = 1.0;
    solid_.cross(ray, scratch_);
    if (scratch_.boundaries.empty()) {
      return -std::numeric_limits<double>::infinity();
    }
    return outward(ray.at(upper_ ? scratch_.boundaries.back().t : scratch_.boundaries.front().t));
  }

  const Solid& solid_;
  int axis_;
  bool upper_;
  Solid::Scratch& scratch_;
};

}  // namespace

Bounds farthest(const Solid& solid, const Extremes& start, double spacing,
                Solid::Scratch& scratch) {
  Bounds box;
  if (start.empty) {
    return box;
  }
  for (int side = 0; side < 6; ++side) {
    const double found =
        Climb(solid, side, scratch).highest(start.points[static_cast<std::size_t>(side)], spacing);
    (side % 2 == 0 ? box.min : box.max)[side / 2] = found;
  }
  return box;
}

}  // namespace raycat
