#include "tracer/extreme_search.hpp"

#include <cmath>
#include <limits>

namespace raycat {
namespace {

constexpr double last_step = 1e-6;
constexpr double shrinking = 0.7;  // where no direction leads on; slow, for they turn meanwhile
constexpr double golden_angle = 2.399963229728653;

// One side of the box.
class Climb {
 public:
  Climb(const Solid& solid, int side, Solid::Scratch& scratch)
      : solid_(solid), axis_(side / 2), upper_(side % 2 == 1), scratch_(scratch) {}

  double highest(const glm::dvec3& start, double step, std::uint64_t rounds) const {
    const Bounds& box = solid_.bounds();
    const double limit = outward(upper_ ? box.max : box.min);
    const double size = 2.0 * box.half_size()[axis_];
    glm::dvec3 best = start;
    double height = outward(start);
    glm::dvec2 progress(0.0, 1.0);
    for (std::uint64_t i = 0; i < rounds && step > last_step && limit - height > 1e-12 * size;
         ++i) {
      const glm::dvec3 from = best;
      // Along the axes and the way it went on, for both often follow a crease, which other
      // directions lead off; and in turning directions.
      const double angle = golden_angle * static_cast<double>(i);
      for (const glm::dvec2& way : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), progress,
                                    glm::dvec2(std::cos(angle), std::sin(angle))}) {
        for (const double along : {step, -step}) {
          const glm::dvec3 next = moved(from, along * way);
          if (const double found = height_at(next); found > height) {
            height = found;
            best = next;
            progress = along < 0.0 ? -way : way;
          }
        }
      }
      step *= best == from ? shrinking : 1.0;
    }
    return upper_ ? height : -height;
  }

 private:
  // By parts of the sides of the box.
  glm::dvec3 moved(glm::dvec3 point, const glm::dvec2& by) const {
    const glm::dvec3 size = 2.0 * solid_.bounds().half_size();
    point[(axis_ + 1) % 3] += by.x * size[(axis_ + 1) % 3];
    point[(axis_ + 2) % 3] += by.y * size[(axis_ + 2) % 3];
    return point;
  }

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

Bounds farthest(const Solid& solid, const Extremes& start, double spacing, std::uint64_t most_rays,
                Solid::Scratch& scratch) {
  constexpr std::uint64_t rays_a_round = 8;
  Bounds box;
  if (start.empty) {
    return box;
  }
  for (int side = 0; side < 6; ++side) {
    const double found = Climb(solid, side, scratch)
                             .highest(start.points[static_cast<std::size_t>(side)], spacing,
                                      most_rays / (6 * rays_a_round));
    (side % 2 == 0 ? box.min : box.max)[side / 2] = found;
  }
  return box;
}

}  // namespace raycat
