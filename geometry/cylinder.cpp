#include <glm/geometric.hpp>

#include "geometry/facing.hpp"
#include "geometry/frustum.hpp"
#include "geometry/shape.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t side = 0;
constexpr std::uint32_t bottom = 1;

Crossing crossing(const Cylinder& cylinder, const Frustum& frustum, FrustumPart part,
                  const glm::dvec3& point) noexcept {
  switch (part) {
    case FrustumPart::bottom:
      // The apex of a cone is part of its side.
      return {.normal{0.0, -1.0, 0.0}, .face = cylinder.radius_bottom > 0.0 ? bottom : side};
    case FrustumPart::top: {
      const std::uint32_t top = cylinder.radius_bottom > 0.0 ? 2 : 1;
      return {.normal{0.0, 1.0, 0.0}, .face = cylinder.radius_top > 0.0 ? top : side};
    }
    case FrustumPart::side:
      break;
  }
  return {.normal = frustum.side_normal(point), .face = side};
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
  Crossing in = crossing(cylinder, frustum, within.in_part, near + within.in * direction);
  in.t = nearest + within.in;
  in.normal = facing(in.normal, direction, true);
  out.push_back(in);
  Crossing leave = crossing(cylinder, frustum, within.out_part, near + within.out * direction);
  leave.t = nearest + within.out;
  leave.normal = facing(leave.normal, direction, false);
  leave.entering = false;
  out.push_back(leave);
  return false;
}

}  // namespace raycat
