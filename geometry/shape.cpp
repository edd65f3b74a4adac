#include "geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/facing.hpp"
#include "geometry/mesh.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bounds around(const glm::dvec3& half_size) { return {.min = -half_size, .max = half_size}; }

Bounds bounds_of(const Sphere& sphere) { return around(glm::dvec3(sphere.radius)); }

Bounds bounds_of(const Box& box) { return around(0.5 * box.size); }

Bounds bounds_of(const Cylinder& cylinder) {
  const double radius = std::max(cylinder.radius_top, cylinder.radius_bottom);
  return around({radius, 0.5 * cylinder.height, radius});
}

Bounds bounds_of(const Capsule& capsule) {
  const double radius = std::max(capsule.radius_top, capsule.radius_bottom);
  const double half = 0.5 * capsule.height;
  return {
      .min{-radius, std::min(-half - capsule.radius_bottom, half - capsule.radius_top), -radius},
      .max{radius, std::max(half + capsule.radius_top, capsule.radius_bottom - half), radius}};
}

Bounds bounds_of(const HalfSpace& /*half_space*/) {
  return {.min = glm::dvec3(-infinity), .max{infinity, 0.0, infinity}};
}

Bounds bounds_of(const Torus& torus) {
  const double radius = torus.radius + torus.tube;
  return around({radius, torus.tube, radius});
}

Bounds bounds_of(const MeshShape& mesh) { return mesh->bounds(); }

template <typename OneFace>
std::uint32_t face_count_of(const OneFace& /*shape*/) {
  return 1;
}

std::uint32_t face_count_of(const Box& /*box*/) { return 6; }

std::uint32_t face_count_of(const Cylinder& cylinder) {
  return 1U + (cylinder.radius_bottom > 0.0 ? 1U : 0U) + (cylinder.radius_top > 0.0 ? 1U : 0U);
}

std::uint32_t face_count_of(const MeshShape& mesh) { return mesh->mesh().face_count; }

void require_positive(std::string_view parameter, double value) {
  if (!std::isfinite(value) || value <= 0.0) {
    throw std::invalid_argument(
        fmt::format("{} must be a finite number above 0, but is {}", parameter, value));
  }
}

void require_not_negative(std::string_view parameter, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw std::invalid_argument(
        fmt::format("{} must be a finite number not below 0, but is {}", parameter, value));
  }
}

// Scene files name the two radii like this, as glTF does.
void require_radii(double top, double bottom) {
  require_not_negative("radiusTop", top);
  require_not_negative("radiusBottom", bottom);
  if (top == 0.0 && bottom == 0.0) {
    throw std::invalid_argument("radiusTop and radiusBottom must not both be 0");
  }
}

void validate_one(const Sphere& sphere) { require_positive("radius", sphere.radius); }

void validate_one(const Box& box) {
  require_positive("size.x", box.size.x);
  require_positive("size.y", box.size.y);
  require_positive("size.z", box.size.z);
}

void validate_one(const Cylinder& cylinder) {
  require_positive("height", cylinder.height);
  require_radii(cylinder.radius_top, cylinder.radius_bottom);
}

void validate_one(const Capsule& capsule) {
  require_not_negative("height", capsule.height);
  require_radii(capsule.radius_top, capsule.radius_bottom);
}

void validate_one(const HalfSpace& /*half_space*/) {}

void validate_one(const Torus& torus) {
  require_positive("radius", torus.radius);
  require_positive("tube", torus.tube);
}

void validate_one(const MeshShape& mesh) {
  if (mesh == nullptr) {
    throw std::invalid_argument("mesh must not be null");
  }
}

}  // namespace

bool cross(const Sphere& sphere, const Ray& ray, Crossings& out) {
  const glm::dvec3& direction = ray.direction;
  const double squared = glm::dot(direction, direction);
  const double middle = -glm::dot(ray.origin, direction) / squared;
  const glm::dvec3 nearest = ray.at(middle);
  const double rest = sphere.radius * sphere.radius - glm::dot(nearest, nearest);
  if (!(rest > 0.0)) {
    return false;
  }
  const double half = std::sqrt(rest / squared);
  if (!(middle - half < middle + half)) {
    return false;  // the line is inside for less than the precision of t: a touch
  }
  out.push_back({.t = middle - half,
                 .normal = facing(nearest - half * direction, direction, true),
                 .entering = true});
  out.push_back({.t = middle + half,
                 .normal = facing(nearest + half * direction, direction, false),
                 .entering = false});
  return false;
}

bool cross(const Box& box, const Ray& ray, Crossings& out) {
  Crossing in{.t = -infinity, .entering = true};
  Crossing leave{.t = infinity, .entering = false};
  int in_axis = 0;
  int out_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * box.size[axis];
    const double origin = ray.origin[axis];
    const double direction = ray.direction[axis];
    if (direction == 0.0) {
      if (origin < -half || origin >= half) {
        return false;
      }
      continue;
    }
    const double side = std::copysign(half, direction);
    const double first = (-side - origin) / direction;
    const double last = (side - origin) / direction;
    if (first > in.t) {
      in.t = first;
      in_axis = axis;
    }
    if (last < leave.t) {
      leave.t = last;
      out_axis = axis;
    }
  }
  if (!(in.t < leave.t)) {
    return false;
  }
  const double in_side = std::copysign(1.0, -ray.direction[in_axis]);
  const double out_side = std::copysign(1.0, ray.direction[out_axis]);
  in.normal[in_axis] = in_side;
  in.face = static_cast<std::uint32_t>(2 * in_axis + (in_side > 0.0 ? 1 : 0));
  in.piece = in.face;
  leave.normal[out_axis] = out_side;
  leave.face = static_cast<std::uint32_t>(2 * out_axis + (out_side > 0.0 ? 1 : 0));
  leave.piece = leave.face;
  out.push_back(in);
  out.push_back(leave);
  return false;
}

bool cross(const HalfSpace& /*half_space*/, const Ray& ray, Crossings& out) {
  if (ray.direction.y == 0.0) {
    return ray.origin.y < 0.0;
  }
  const bool entering = ray.direction.y < 0.0;
  out.push_back(
      {.t = -ray.origin.y / ray.direction.y, .normal{0.0, 1.0, 0.0}, .entering = entering});
  return !entering;
}

bool cross(const MeshShape& mesh, const Ray& ray, Crossings& out) {
  mesh->cross(ray, out);
  return false;
}

bool cross(const Shape& shape, const Ray& ray, Crossings& out) {
  return std::visit([&](const auto& one) { return cross(one, ray, out); }, shape);
}

Bounds bounds(const Shape& shape) {
  return std::visit([](const auto& one) { return bounds_of(one); }, shape);
}

std::uint32_t face_count(const Shape& shape) {
  return std::visit([](const auto& one) { return face_count_of(one); }, shape);
}

void validate(const Shape& shape) {
  std::visit([](const auto& one) { validate_one(one); }, shape);
}

}  // namespace raycat
