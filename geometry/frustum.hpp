#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

namespace raycat {

struct Capsule;
struct Cylinder;

/// The solid of revolution around Y between two heights whose radius is
/// `radius + slope * (y - middle)`, nowhere negative: a cylinder, a cone or a part of one.
struct Frustum {
  double middle = 0.0;  ///< height of its middle
  double half_height = 0.0;
  double radius = 0.0;  ///< in the middle
  double slope = 0.0;   ///< growth of the radius with y

  /// Points out of the side, at a point of the side. Of any length above 0.
  glm::dvec3 side_normal(const glm::dvec3& point) const noexcept;
};

/// What the side of a cylinder or a cone bounds.
Frustum side_of(const Cylinder& cylinder) noexcept;

/// What touches both balls of a capsule, between the circles where it does; nothing if one ball
/// holds the other.
std::optional<Frustum> side_of(const Capsule& capsule) noexcept;

/// In the order of a capsule's pieces.
enum class FrustumPart : std::uint8_t { side, bottom, top };

/// The part of a line within a frustum, in units of its direction.
struct FrustumSpan {
  double in = 0.0;
  double out = 0.0;  ///< not above `in` if the line misses or only touches
  FrustumPart in_part = FrustumPart::side;
  FrustumPart out_part = FrustumPart::side;
};

/// Where the line `near + s * direction` is within `frustum`. The closer `near` is to the
/// frustum, the less is lost to cancellation. A line within the plane of the bottom counts as
/// inside it, one within the plane of the top does not.
FrustumSpan span(const Frustum& frustum, const glm::dvec3& near,
                 const glm::dvec3& direction) noexcept;

}  // namespace raycat
