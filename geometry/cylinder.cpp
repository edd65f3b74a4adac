#include <glm/geometric.hpp>

#include "geometry/facing.hpp"
#include "geometry/frustum.hpp"
#include "geometry/shape.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t side = 0;
constexpr std::uint32_t bottom = 1;

// The apex of a cone is part of its side.
std::uint32_t face_of(const Cylinder& cylinder, FrustumPart part) noexcept {
  switch (part) {
    case FrustumPart::bottom:
      return cylinder.radius_bottom > 0.0 ? bottom : side;
    case FrustumPart::top:
      return cylinder.radius_top > 0.0 ? (cylinder.radius_bottom > 0.0 ? 2 : 1) : side;
    case FrustumPart::side:
      break;
  }
  return side;
}

glm::dvec3 normal_of(const Frustum& frustum, FrustumPart part, const glm::dvec3& point) noexcept {
  switch (part) {
    case FrustumPart::bottom:
      return {0.0, -1.0, 0.0};
    case FrustumPart::top:
      return {0.0, 1.0, 0.0};
    case FrustumPart::side:
      break;
  }
  return frustum.side_normal(point);
}

}  // namespace

Frustum side_of(const Cylinder& cylinder) noexcept {
  return {.half_height = 0.5 * cylinder.height,
          .radius = 0.5 * (cylinder.radius_top + cylinder.radius_bottom),
          .slope = (cylinder.radius_top - cylinder.radius_bottom) / cylinder.height};
}

bool cross(const Cylinder& cylinder, const Ray& ray, Crossings& out) {
  const glm::dvec3& direction = ray.direction;
  const double nearest = -glm::dot(ray.origin, direction) / glm::dot(direction, direction);
  const glm::dvec3 near = ray.at(nearest);
  const Frustum frustum = side_of(cylinder);
  const FrustumSpan within = span(frustum, near, direction);
  if (!(nearest + within.in < nearest + within.out)) {
    return false;
  }
  for (const bool entering : {true, false}) {
    const double at = entering ? within.in : within.out;
    const FrustumPart part = entering ? within.in_part : within.out_part;
    const std::uint32_t face = face_of(cylinder, part);
    const glm::dvec3 normal = normal_of(frustum, part, near + at * direction);
    out.push_back({.t = nearest + at,
                   .normal = facing(normal, direction, entering),
                   .face = face,
                   .piece = face,
                   .entering = entering});
  }
  return false;
}

}  // namespace raycat
