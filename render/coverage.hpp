#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "antialias/antialias.hpp"
#include "categories/detail.hpp"
#include "raytree/ray_tree.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// The categories that cover most of each pixel, the largest first.
struct CoverageImage {
  int width = 0;
  int height = 0;
  int ranks = 0;
  std::vector<std::uint32_t> ids;  ///< `ranks` a pixel, rows from the top; 0 where the share is 0
  std::vector<float> shares;       ///< likewise; a pixel's sum to 1
  std::size_t categories = 0;      ///< that there are in all
};

/// Of a picture with its coverage. Categories are those of a level of detail, numbered from 1 in
/// the order in which they are met, row by row and, within a pixel, by size. `tree_of` tells the
/// picture's trees. What does not fit `ranks` is left out, and the rest made to sum to 1.
CoverageImage coverage_image(const AntialiasedPicture& picture,
                             const std::function<const RayTree&(TreeId)>& tree_of,
                             const SurfaceTable& surfaces, const Detail& detail, int ranks);

}  // namespace raycat
