#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/raw_array.hpp"

namespace raycat {

/// For each point, the number of the first point equal to it (-0 equals 0). Points are compared
/// exactly; what is not finite equals only itself. Throws `std::length_error` if the points cannot
/// be numbered in 32 bits.
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions, int threads = 1);

/// The triangles with each corner replaced by `first` of it, as `weld` gives it.
RawArray<glm::uvec3> welded(std::span<const glm::uvec3> triangles,
                            std::span<const std::uint32_t> first, int threads);

}  // namespace raycat
