#pragma once

#include <optional>

#include "raytree/ray_tree.hpp"

namespace raycat {

/// What tells two ray trees apart, where one node is enough: all that is different is at this
/// position or below it.
struct TreeDifference {
  HeapPosition position = root;
  std::optional<SurfaceId> a;  ///< what is met there; nothing if nothing is, or no ray goes there
  std::optional<SurfaceId> b;
  std::optional<int> light;  ///< the only one that reaches the node in one of the trees alone
  bool lit_in_a = false;     ///< is that tree `a`?
};

/// Nothing if they are equal, or more than one node or light is needed to tell them apart.
std::optional<TreeDifference> tree_difference(const RayTree& a, const RayTree& b);

/// The node of a tree at a position; null if there is none.
const RayNode* node_at(const RayTree& tree, HeapPosition position);

}  // namespace raycat
