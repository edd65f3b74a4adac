#include "tracer/camera.hpp"

#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace raycat {
namespace {

constexpr double default_fov = 0.6981317007977318;  // radians; 40 degrees

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// +X without its part along `axis`, a unit vector, or +Y if that leaves next to nothing; of
// length 1.
glm::dvec3 side_across(const glm::dvec3& axis) {
  const glm::dvec3 side = std::abs(axis.x) < 0.999 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(side - glm::dot(side, axis) * axis);
}

}  // namespace

Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  if (!finite(eye) || !finite(target) || !finite(up)) {
    throw std::invalid_argument("eye, target and up of a view must be finite numbers");
  }
  const glm::dvec3 way = target - eye;
  const double distance = glm::length(way);
  if (!(distance > 0.0) || !std::isfinite(distance)) {
    throw std::invalid_argument("eye and target of a view must differ");
  }
  Camera camera{.eye = eye, .forward = way / distance, .half_height = std::tan(default_fov / 2)};
  const glm::dvec3 right = glm::cross(camera.forward, up);
  camera.right = glm::length(right) > 1e-9 * glm::length(up) ? glm::normalize(right)
                                                             : side_across(camera.forward);
  camera.up = glm::cross(camera.right, camera.forward);
  return camera;
}

Orbit orbit(const glm::dvec3& up, double azimuth, double elevation) {
  const glm::dvec3 axis = glm::normalize(up);
  const glm::dvec3 side = side_across(axis);
  const glm::dvec3 front = glm::cross(side, axis);
  const glm::dvec3 level = std::sin(azimuth) * side + std::cos(azimuth) * front;
  return {.towards_eye = std::cos(elevation) * level + std::sin(elevation) * axis,
          .up = std::cos(elevation) * axis - std::sin(elevation) * level};
}

glm::dvec3 three_quarter(const glm::dvec3& up) {
  return orbit(up, 0.6108652381980153, 0.4363323129985824).towards_eye;
}

Camera frame(const Bounds& bounds, const glm::dvec3& towards_eye, const glm::dvec3& up,
             double aspect, bool orthographic) {
  constexpr double margin = 1.08;
  const bool nothing = bounds.empty() || !bounds.finite();
  const Bounds box = nothing ? Bounds{.min = glm::dvec3(-1.0), .max = glm::dvec3(1.0)} : bounds;
  // At the origin, since far from it a step of one may be none.
  Camera camera = look_at(towards_eye, glm::dvec3(0.0), up);

  // The least distance, or half height, at which every corner of the box is in view.
  const double slope = std::tan(default_fov / 2) / margin;
  double distance = 0.0;
  double half_height = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 offset = glm::dvec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                         (corner & 4) != 0 ? 1 : -1) *
                              box.half_size();
    const double across = std::max(std::abs(glm::dot(offset, camera.up)),
                                   std::abs(glm::dot(offset, camera.right)) / aspect);
    distance = std::max(distance, glm::dot(offset, towards_eye) + across / slope);
    half_height = std::max(half_height, margin * across);
  }
  const bool point = !(distance > 0.0);  // all bounds are one point
  camera.eye = box.center() + (point ? 1.0 : distance) * towards_eye;
  camera.orthographic = orthographic;
  if (orthographic) {
    camera.half_height = point ? 1.0 : half_height;
  }
  return camera;
}

Camera orthographic(Camera camera, double distance) {
  if (!camera.orthographic) {
    camera.orthographic = true;
    camera.half_height *= distance;
  }
  return camera;
}

ImagePlane::ImagePlane(const Camera& camera, int width, int height)
    : camera_(camera),
      pixel_(2.0 * camera.half_height / height),
      centre_x_(0.5 * width),
      centre_y_(0.5 * height) {}

Ray ImagePlane::ray(double x, double y) const noexcept {
  const glm::dvec3 across =
      pixel_ * ((x - centre_x_) * camera_.right - (y - centre_y_) * camera_.up);
  if (camera_.orthographic) {
    return {.origin = camera_.eye + across, .direction = camera_.forward};
  }
  return {.origin = camera_.eye, .direction = glm::normalize(camera_.forward + across)};
}

glm::dvec2 ImagePlane::project(const glm::dvec3& point) const noexcept {
  const glm::dvec3 way = point - camera_.eye;
  const double scale = (camera_.orthographic ? 1.0 : 1.0 / glm::dot(way, camera_.forward)) / pixel_;
  return {centre_x_ + scale * glm::dot(way, camera_.right),
          centre_y_ - scale * glm::dot(way, camera_.up)};
}

}  // namespace raycat
