#pragma once

#include <memory>

#include "categories/path_expression.hpp"
#include "raytree/ray_tree.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// How much of a ray tree its category keeps: the level of detail of Section 3, Fig. 7.
struct Detail {
  int levels = most_levels;  ///< keep the nodes of so many levels, from the root
  bool lights = true;        ///< keep which lights reach each node
  Granularity ids = Granularity::face;
  float min_weight = 0.0f;  ///< drop nodes that can count for less in the pixel

  /// Keep what this accepts; all if null.
  std::shared_ptr<const PathExpression> paths;
};

/// Reduces `tree`, whose surfaces are faces, in place to what `detail` keeps. Its surfaces then are
/// ids of `detail.ids`, and one more for those that `detail.paths` leaves untold.
/// Reducing a copy again and again serves every level of detail with one trace.
void reduce(RayTree& tree, const Detail& detail, const SurfaceTable& surfaces);

}  // namespace raycat
