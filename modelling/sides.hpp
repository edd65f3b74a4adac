#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "csg/leaf_bvh.hpp"
#include "modelling/exact.hpp"

namespace raycat {

/// Finds exactly how often a point is surrounded by the surfaces of closed meshes, by a line from
/// it to infinity.
class Sides {
 public:
  /// A triangle that the line goes through at the point or past it.
  struct Passage {
    std::uint32_t triangle = 0;
    bool here = false;     ///< is the point on it?
    bool leaving = false;  ///< does the line come out of the triangle's front?
  };

  /// Refers to its arguments, which must stay where they are.
  Sides(std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
        std::span<const std::uint8_t> wanted);

  /// Sets `out` to all triangles on a line from the point, which goes roughly along `direction`
  /// and through the inside of each. The point must not be on an edge of a wanted triangle; those
  /// not wanted are not met where it is on them. Triangles whose corners are in a row are never
  /// met.
  void pass(const Exact::Point_3& point, glm::dvec3 direction, std::vector<Passage>& out) const;

 private:
  bool try_pass(const Exact::Point_3& point, const glm::dvec3& direction,
                std::vector<Passage>& out) const;

  std::span<const Exact::Point_3> points_;
  std::span<const glm::uvec3> triangles_;
  std::span<const std::uint8_t> wanted_;
  LeafBvh index_;
};

}  // namespace raycat
