#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "modelling/exact.hpp"

namespace raycat {

/// What is known of triangles that lie in surfaces which several owners share.
struct FlushTriangles {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> owner;     ///< of each triangle
  std::vector<std::uint32_t> surface;   ///< the shared surface that each is of, or `none`
  std::vector<std::uint32_t> spanning;  ///< a triangle in each surface; `none` of a curved one
};

/// Exact places for the corners of triangles, so that those which coincide but for rounding or the
/// tolerance do so. Triangles of one flat surface lie in the plane of the one that spans it. Of
/// facets of curved surfaces, those of two owners that are nowhere farther apart than twice the
/// tolerance lie in one plane. A corner on up to three of these planes is moved onto them, by a few
/// tolerances at most. Other corners stay where they are.
std::vector<Exact::Point_3> onto_flush_planes(std::span<const glm::dvec3> positions,
                                              std::span<const glm::uvec3> triangles,
                                              const FlushTriangles& flush, double tolerance);

}  // namespace raycat
