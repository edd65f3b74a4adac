#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>

#include "geometry/shape.hpp"

namespace raycat {

/// An invertible affine map, also mirrored or sheared, with its inverse.
class Affine {
 public:
  Affine() = default;

  /// Throws `std::invalid_argument` if the last row is not (0, 0, 0, 1), a number is not finite
  /// or the map is singular. Singular means that no inverse exists in double precision, not that
  /// the determinant is small: a scale of 1e-6 is fine.
  explicit Affine(const glm::dmat4& matrix);

  Ray to_local(const Ray& ray) const noexcept {
    return {.origin = inverse_linear_ * (ray.origin - translation_),
            .direction = inverse_linear_ * ray.direction};
  }

  glm::dvec3 point(const glm::dvec3& local) const noexcept {
    return linear_ * local + translation_;
  }

  /// Maps a normal so that it stays perpendicular to its surface and on its side, mirrored or
  /// not. Unit length.
  glm::dvec3 normal(const glm::dvec3& local) const noexcept;

  /// The box around the image of `local`. An infinite box becomes infinite on every side.
  Bounds bounds(const Bounds& local) const noexcept;

  bool mirrored() const noexcept { return glm::determinant(linear_) < 0.0; }
  glm::dmat4 matrix() const noexcept;
  const glm::dvec3& translation() const noexcept { return translation_; }
  const glm::dmat3& inverse_linear() const noexcept { return inverse_linear_; }

 private:
  glm::dmat3 linear_{1.0};
  glm::dmat3 inverse_linear_{1.0};
  glm::dvec3 translation_{0.0};
};

/// A shape somewhere in the world.
class PlacedShape {
 public:
  /// Throws `std::invalid_argument` as `validate(shape)` does.
  explicit PlacedShape(Shape shape, const Affine& transform = {});

  /// As `raycat::cross`, t in units of the world ray. The normals stay in the shape's frame:
  /// `normal` takes the one that is wanted to the world.
  bool cross_local(const Ray& world, Crossings& out) const {
    return raycat::cross(shape_, transform_.to_local(world), out);
  }

  /// As `cross_local`, with unit normals in the world.
  bool cross(const Ray& world, Crossings& out) const;

  glm::dvec3 normal(const Crossing& local) const noexcept {
    return transform_.normal(local.normal);
  }

  const Shape& shape() const noexcept { return shape_; }
  const Affine& transform() const noexcept { return transform_; }
  const Bounds& bounds() const noexcept { return bounds_; }
  std::uint32_t face_count() const { return raycat::face_count(shape_); }

 private:
  Shape shape_;
  Affine transform_;
  Bounds bounds_;
};

}  // namespace raycat
