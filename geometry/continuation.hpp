#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/vec3.hpp>

#include "geometry/crease.hpp"
#include "geometry/mesh_faces.hpp"
#include "geometry/raw_array.hpp"

namespace raycat {

/// A triangle's side along an edge, or part of one: a half-edge as `EdgeUses` numbers them, from
/// and to which part of its length.
struct TriangleSide {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t half = none;
  double from = 0.0;
  double to = 1.0;
};

/// Which triangles continue each other over an edge, by angle or by authored normals.
class Continuation {
 public:
  /// Keeps references to all, as `group_faces` has them.
  Continuation(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
               std::span<const glm::vec3> normals, const FaceRule& rule, int threads);

  /// Is the triangle's height nothing beside its longest side? Such a one continues nothing.
  bool degenerate(std::uint32_t triangle) const { return planes_[triangle] == glm::dvec3(0.0); }

  bool some_degenerate() const noexcept { return some_degenerate_; }

  /// Do two triangles continue each other over sides at one place? If the sides do not run in
  /// opposite directions, one of the triangles is turned over.
  bool over(const TriangleSide& a, const TriangleSide& b, bool opposite) const {
    const std::uint32_t triangle = a.half / 3;
    const std::uint32_t other = b.half / 3;
    if (degenerate(triangle) || degenerate(other)) {
      return false;
    }
    const glm::dvec3 turned = opposite ? planes_[other] : -planes_[other];
    const auto tilts = [&] { return tilt(triangle) + tilt(other); };
    return crease_.joins(planes_[triangle], turned, tilts) ||
           (!normals_.empty() && smooth(a, b, opposite));
  }

 private:
  bool smooth(const TriangleSide& a, const TriangleSide& b, bool opposite) const;
  double tilt(std::uint32_t triangle) const;
  bool same_normals(const glm::dvec3& a, const glm::dvec3& b) const;
  glm::dvec3 normal(std::uint32_t half, double at) const;

  std::span<const glm::dvec3> positions_;
  std::span<const glm::uvec3> triangles_;
  std::span<const glm::vec3> normals_;  // authored, one a position, or none
  Crease crease_;
  double same_normal_;           // the least cosine
  RawArray<glm::dvec3> planes_;  // unit normals; zero for degenerate triangles
  std::atomic<bool> some_degenerate_ = false;
};

}  // namespace raycat
