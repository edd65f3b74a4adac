#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// For each point, the number of the first point equal to it (-0 equals 0). Points are compared
/// exactly; what is not finite equals only itself. Throws `std::length_error` if the points cannot
/// be numbered in 32 bits.
std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions, int threads = 1);

}  // namespace raycat
