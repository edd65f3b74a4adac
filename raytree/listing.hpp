#pragma once

#include "raytree/ray_tree.hpp"

namespace raycat {

/// Does a tree's list name the node at `a` before the one at `b`? Refraction subtree, reflection
/// subtree, node, as `RayTree` has it.
constexpr bool listed_before(HeapPosition a, HeapPosition b) noexcept {
  const int deeper = level(a) - level(b);
  const HeapPosition a_there = deeper > 0 ? a >> deeper : a;  // on the higher of both levels
  const HeapPosition b_there = deeper < 0 ? b >> -deeper : b;
  return a_there != b_there ? a_there < b_there : deeper > 0;
}

/// Puts nodes that were recorded in any order into that of a `RayTree`. Ray tracers that do not
/// recurse call it before they encode, lest equal trees have different words. The positions must
/// be distinct.
void sort_as_listed(RayTree& tree);

}  // namespace raycat
