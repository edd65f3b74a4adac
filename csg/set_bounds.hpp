#pragma once

#include <vector>

#include "csg/tree.hpp"
#include "geometry/bounds.hpp"

namespace raycat {

/// A box around each node's set, by index into `tree.nodes()`, no larger than its operands' boxes
/// make necessary. Infinite sides where a half-space leaves it unbounded; may be empty.
std::vector<Bounds> set_bounds(const CsgTree& tree);

/// The part of each leaf's box where the leaf can make a difference to the root, `margin` added
/// around the bounds that its ancestors set: A - B is within A, and A and B within both. By index
/// into `tree.leaves()`; empty for a leaf that never matters. `bounds` are the tree's `set_bounds`.
std::vector<Bounds> leaf_reach(const CsgTree& tree, const std::vector<Bounds>& bounds,
                               double margin);

}  // namespace raycat
