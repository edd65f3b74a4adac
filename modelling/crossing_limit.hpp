#pragma once

#include <span>

#include "modelling/winding.hpp"

namespace raycat {

/// Throws `std::length_error` if edges cross or overlap in more than 200 000 places, since n of
/// them can in n^2; or if so many pass each other closely that they cannot be counted soon.
void require_few_crossings(std::span<const WindingEdge> edges);

}  // namespace raycat
