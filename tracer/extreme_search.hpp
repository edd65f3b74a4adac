#pragma once

#include <cstdint>

#include "csg/solid.hpp"
#include "tracer/chord_sums.hpp"

namespace raycat {

/// The box around a solid, searched for by rays that climb from the farthest points known, `start`,
/// in steps from `spacing` of the sides of the solid's box down to 1e-6 of them, or until
/// `most_rays` are cast. It is around `start`, and within the solid's own box but for rounding.
Bounds farthest(const Solid& solid, const Extremes& start, double spacing, std::uint64_t most_rays,
                Solid::Scratch& scratch);

}  // namespace raycat
