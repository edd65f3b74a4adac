#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "geometry/facing.hpp"
#include "geometry/frustum.hpp"
#include "geometry/shape.hpp"

namespace raycat {
namespace {

struct Ball {
  double height = 0.0;  ///< of its centre
  double radius = 0.0;
};

/// One end of the line's part within the capsule.
struct End {
  double s = 0.0;
  FrustumPart part = FrustumPart::side;  ///< top and bottom are the balls
};

/// The line `near + s * direction` and its part within the pieces of one convex solid.
struct Chord {
  glm::dvec3 near;
  glm::dvec3 direction;
  End in{.s = std::numeric_limits<double>::infinity()};
  End out{.s = -std::numeric_limits<double>::infinity()};

  void include(const End& piece_in, const End& piece_out) {
    if (!(piece_in.s < piece_out.s)) {
      return;
    }
    if (piece_in.s < in.s) {
      in = piece_in;
    }
    if (piece_out.s > out.s) {
      out = piece_out;
    }
  }

  void include(const Ball& ball, FrustumPart part) {
    const double squared = glm::dot(direction, direction);
    const glm::dvec3 from_center = near - glm::dvec3(0.0, ball.height, 0.0);
    const double middle = -glm::dot(from_center, direction) / squared;
    const glm::dvec3 nearest = from_center + middle * direction;
    const double rest = ball.radius * ball.radius - glm::dot(nearest, nearest);
    if (rest > 0.0) {
      const double half = std::sqrt(rest / squared);
      include({middle - half, part}, {middle + half, part});
    }
  }
};

glm::dvec3 ball_normal(const Ball& ball, const glm::dvec3& point) {
  if (ball.radius == 0.0) {
    return {0.0, ball.height, 0.0};  // the apex has many normals, and the axis is one
  }
  return point - glm::dvec3(0.0, ball.height, 0.0);
}

}  // namespace

// With the angle whose sine is the fall of the radii over the height, the circles lie sine times
// the radius above each centre.
std::optional<Frustum> side_of(const Capsule& capsule) noexcept {
  const double fall = capsule.radius_bottom - capsule.radius_top;
  if (!(std::abs(fall) < capsule.height)) {
    return std::nullopt;
  }
  const double sine = fall / capsule.height;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  return Frustum{.middle = 0.5 * sine * (capsule.radius_top + capsule.radius_bottom),
                 .half_height = 0.5 * capsule.height * cosine * cosine,
                 .radius = 0.5 * cosine * (capsule.radius_top + capsule.radius_bottom),
                 .slope = -sine / cosine};
}

bool cross(const Capsule& capsule, const Ray& ray, Crossings& out) {
  const double nearest =
      -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
  Chord chord{.near = ray.at(nearest), .direction = ray.direction};
  const Ball top{.height = 0.5 * capsule.height, .radius = capsule.radius_top};
  const Ball bottom{.height = -0.5 * capsule.height, .radius = capsule.radius_bottom};
  chord.include(top, FrustumPart::top);
  chord.include(bottom, FrustumPart::bottom);
  const std::optional<Frustum> cone = side_of(capsule);
  if (cone) {
    const FrustumSpan within = span(*cone, chord.near, chord.direction);
    chord.include({within.in, within.in_part}, {within.out, within.out_part});
  }
  if (!(nearest + chord.in.s < nearest + chord.out.s)) {
    return false;
  }
  for (const bool entering : {true, false}) {
    const End& end = entering ? chord.in : chord.out;
    const glm::dvec3 point = chord.near + end.s * chord.direction;
    const glm::dvec3 normal = end.part == FrustumPart::side  ? cone->side_normal(point)
                              : end.part == FrustumPart::top ? ball_normal(top, point)
                                                             : ball_normal(bottom, point);
    out.push_back({.t = nearest + end.s,
                   .normal = facing(normal, chord.direction, entering),
                   .piece = static_cast<std::uint32_t>(end.part),
                   .entering = entering});
  }
  return false;
}

}  // namespace raycat
