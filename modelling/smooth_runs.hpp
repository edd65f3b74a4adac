#pragma once

#include <cstdint>
#include <vector>

#include "modelling/polygons.hpp"

namespace raycat {

/// For each edge of a contour (edge i begins at corner i) the number of its run, from 0: edges
/// are of one run that turn less than 30 degrees from one to the next.
std::vector<std::uint32_t> smooth_runs(const Contour& contour);

}  // namespace raycat
