#pragma once

#include <cstdint>

#include "modelling/polygons.hpp"

namespace raycat {

/// How an offset goes round a corner: `round` by an arc of facets; `mitre` on along both edges
/// until they meet, however far; `chamfer` by an edge as far from the corner as all others are.
enum class Join { round, mitre, chamfer };

/// All that is within `distance` of the polygons, or for a negative one all that is farther than
/// it from their outside, but for the joins. An arc has facets of 360 degrees / `facets` each from
/// the normal of the edge before the corner on, and the last takes the rest, up to half more or
/// less; `facets` is that of a circle of radius |distance|. This is OpenSCAD's `offset`: `round`
/// for `r`, `mitre` for `delta`, and `chamfer` for `delta` with `chamfer = true`.
Polygons offset(const Polygons& polygons, double distance, Join join, std::uint32_t facets);

}  // namespace raycat
