#include "geometry/placed_shape.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "geometry/facing.hpp"

namespace raycat {
namespace {

bool finite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) {
        return false;
      }
    }
  }
  return true;
}

// The most by which an entry of `matrix` differs from the identity's; NaN counts as infinite.
double distance_from_identity(const glm::dmat3& matrix) {
  double most = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double off = std::abs(matrix[column][row] - (column == row ? 1.0 : 0.0));
      most = off <= most ? most : std::isnan(off) ? std::numeric_limits<double>::infinity() : off;
    }
  }
  return most;
}

// In extended precision, in which the determinant of no invertible map underflows.
glm::dmat3 inverse(const glm::dmat3& matrix) {
  const glm::mat<3, 3, long double> exact(matrix);
  return {glm::inverse(exact)};
}

}  // namespace

Affine::Affine(const glm::dmat4& matrix) : linear_(matrix), translation_(matrix[3]) {
  if (!finite(matrix)) {
    throw std::invalid_argument("transform must be of finite numbers");
  }
  if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0) {
    throw std::invalid_argument("transform must have (0, 0, 0, 1) as its last row");
  }
  inverse_linear_ = inverse(linear_);
  // Far beyond what rounding does to stretches of 1e6 along one axis and 1e-6 along another.
  constexpr double nonsense = 1e-3;
  if (distance_from_identity(linear_ * inverse_linear_) > nonsense) {
    throw std::invalid_argument("transform must be invertible, but is singular");
  }
}

glm::dvec3 Affine::normal(const glm::dvec3& local) const noexcept {
  return glm::normalize(local * inverse_linear_);
}

Bounds Affine::bounds(const Bounds& local) const noexcept {
  if (local.empty()) {
    return {};
  }
  if (!local.finite()) {
    const glm::dvec3 infinite(std::numeric_limits<double>::infinity());
    return {.min = -infinite, .max = infinite};
  }
  Bounds image{.min = translation_, .max = translation_};
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 from = linear_[axis] * local.min[axis];
    const glm::dvec3 to = linear_[axis] * local.max[axis];
    image.min += glm::min(from, to);
    image.max += glm::max(from, to);
  }
  return image;
}

glm::dmat4 Affine::matrix() const noexcept {
  glm::dmat4 result(linear_);
  result[3] = glm::dvec4(translation_, 1.0);
  return result;
}

PlacedShape::PlacedShape(Shape shape, const Affine& transform)
    : shape_(std::move(shape)), transform_(transform) {
  validate(shape_);
  bounds_ = transform_.bounds(raycat::bounds(shape_));
}

bool PlacedShape::cross(const Ray& world, Crossings& out) const {
  const std::size_t first = out.size();
  const bool inside = cross_local(world, out);
  for (std::size_t i = first; i < out.size(); ++i) {
    out[i].normal = facing(normal(out[i]), world.direction, out[i].entering);
  }
  return inside;
}

}  // namespace raycat
