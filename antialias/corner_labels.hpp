#pragma once

#include <array>

#include "antialias/over_lattice.hpp"

namespace raycat {

/// A square's corners by label: those of one label are taken for one surface.
struct CornerLabels {
  std::array<int, 4> of{};
  int count = 0;
  float apart = 0.0f;     ///< the greatest distance of two corners of different labels
  float farthest = 0.0f;  ///< and that of any two
};

/// Corners start with a label for each tree, or each for itself if colours decide or all are of one
/// tree, and labels are joined while all their corners are less than `least` apart, or less than
/// `share` of the greatest distance (complete linkage).
CornerLabels label_corners(const Corners& corners, bool by_colour, float least, float share);

/// Which corner's label a sample has: of the same tree, or if colours decide or it met a texture,
/// of the nearest colour. -1 if it is of none.
int label_of(const ColourSample& sample, const Corners& corners, const CornerLabels& labels,
             bool by_colour);

}  // namespace raycat
