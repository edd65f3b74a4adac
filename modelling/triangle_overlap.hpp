#pragma once

#include <array>
#include <vector>

#include "modelling/exact.hpp"

namespace raycat {

using RationalPoint = Exact::Exact_kernel::Point_3;

/// What two triangles have in common, as segments to draw on each. Those from a point to itself are
/// points. In one plane, each has the other's edges drawn on it, else both have the same segment.
struct TriangleOverlap {
  using Segment = std::array<RationalPoint, 2>;

  std::vector<Segment> on_a;
  std::vector<Segment> on_b;
};

/// The corners of a triangle must not be in a row. Exact.
TriangleOverlap triangle_overlap(const std::array<RationalPoint, 3>& a,
                                 const std::array<RationalPoint, 3>& b);

}  // namespace raycat
