#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bounds.hpp"

namespace raycat {

/// The group of each box, numbered from 0 in the order of each group's first box: boxes that
/// touch or overlap are of one group, and so are those that a chain of such boxes joins. No box
/// is empty.
std::vector<std::uint32_t> group_touching(std::span<const Bounds> boxes);

}  // namespace raycat
