#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "modelling/exact.hpp"

namespace raycat {

/// All pairs of triangles that have more in common than corners and edges of both. Only triangles
/// marked in `wanted` are looked at; those have corners that are not in a row. Exact. Throws
/// `std::length_error` if there are more than 2^23.
std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_triangles(
    std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
    std::span<const std::uint8_t> wanted);

}  // namespace raycat
