#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "modelling/exact.hpp"

namespace raycat {

/// Exact places for the corners of triangles, so that faces of different `owner`s that lie in one
/// plane but for rounding lie in one plane. Planes that are nowhere farther apart on a triangle
/// than `tolerance` count as one; a corner on up to three of those that two owners share is moved
/// onto them, by a few tolerances at most. Other corners stay where they are.
std::vector<Exact::Point_3> onto_flush_planes(std::span<const glm::dvec3> positions,
                                              std::span<const glm::uvec3> triangles,
                                              std::span<const std::uint32_t> owner,
                                              double tolerance);

}  // namespace raycat
