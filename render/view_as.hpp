#pragma once

#include <array>
#include <string>
#include <string_view>

#include "categories/category_trees.hpp"
#include "tracer/image.hpp"

namespace raycat {

/// What a false-colour image shows of each pixel's ray tree.
enum class View {
  depth,    ///< levels of the tree
  nodes,    ///< intersections in the tree
  lights,   ///< lights that reach the surface seen
  branch,   ///< which child of the root has more nodes under it: the reflection or the refraction
  category  ///< a colour for each category
};

inline constexpr std::array all_views{View::depth, View::nodes, View::lights, View::branch,
                                      View::category};

/// depth, nodes, lights, branch or category.
std::string_view name(View view);

/// A false-colour image.
struct ViewImage {
  Image image;
  std::string legend;  ///< what its colours mean, in a line
};

/// Shows `view` of the image of `trees`. Numbers are coloured by the viridis map from
/// 0, dark blue, to the most there is in the image, yellow. Rays that leave the scene are white.
/// Throws `std::logic_error` as `CategoryTrees` does, but for `View::category`.
ViewImage view_image(CategoryTrees& trees, View view);

}  // namespace raycat
