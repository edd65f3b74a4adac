#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raycat {

/// Radians by which an angle is under a crease, at least, so that rounding does not decide of those
/// that are meant to equal it: 0.005 degrees, which is what five digits leave of a polygon's angle.
inline constexpr double crease_slack = 8.726646259971648e-05;

/// By how much, in radians, rounding its corners to float can have turned the plane of a triangle,
/// to first order. Infinite if the corners are in a row.
double rounding_tilt(const std::array<glm::dvec3, 3>& corners);

/// The angle between planes from which on faces part. One that equals it parts them, and so does
/// one that may have been equal to it before corners were rounded: an angle joins if it is less by
/// more than the tilts of both triangles, or than `crease_slack` if that is more, but a 32nd of the
/// crease is always enough, since angles between slivers are noise.
class Crease {
 public:
  /// Radians, from 0 to pi.
  explicit Crease(double angle)
      : angle_(angle),
        most_slack_(angle / 32.0),
        chord_(2.0 * std::sin(0.5 * angle)),
        sure_chord_(2.0 * std::sin(0.5 * (angle - most_slack_))) {}

  /// Do planes with these unit normals join? `tilts()` is the sum of the two triangles' tilts, and
  /// is asked only close to the crease.
  template <class Tilts>
  bool joins(const glm::dvec3& a, const glm::dvec3& b, const Tilts& tilts) const {
    // The chord, unlike the cosine, tells small angles apart.
    const glm::dvec3 chord = a - b;
    const double square = glm::dot(chord, chord);
    if (square < sure_chord_ * sure_chord_) {
      return true;
    }
    if (square >= chord_ * chord_) {
      return false;
    }
    const double slack = std::min(std::max(crease_slack, tilts()), most_slack_);
    return 2.0 * std::asin(0.5 * std::sqrt(square)) < angle_ - slack;
  }

 private:
  double angle_;
  double most_slack_;
  double chord_;
  double sure_chord_;
};

}  // namespace raycat
