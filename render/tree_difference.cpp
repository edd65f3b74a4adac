#include "render/tree_difference.hpp"

#include <algorithm>
#include <bit>

namespace raycat {
namespace {

// Is `position` below `above`, or the same?
bool within(HeapPosition position, HeapPosition above) {
  const int levels = level(position) - level(above);
  return levels >= 0 && position >> levels == above;
}

// Calls `different(position)` for each node of `a` that `b` does not have as it is.
template <typename Different>
void each_difference(const RayTree& a, const RayTree& b, const Different& different) {
  for (const RayNode& node : a) {
    const RayNode* other = node_at(b, node.position);
    if (other == nullptr || !(*other == node)) {
      different(node.position);
    }
  }
}

}  // namespace

const RayNode* node_at(const RayTree& tree, HeapPosition position) {
  const auto found = std::ranges::find(tree, position, &RayNode::position);
  return found == tree.end() ? nullptr : &*found;
}

std::optional<TreeDifference> tree_difference(const RayTree& a, const RayTree& b) {
  // A node's number is greater than those of all that are above it.
  HeapPosition top = ~HeapPosition{0};
  const auto lower = [&](HeapPosition position) { top = std::min(top, position); };
  each_difference(a, b, lower);
  each_difference(b, a, lower);
  if (top == ~HeapPosition{0}) {
    return std::nullopt;
  }
  bool one = true;
  const auto check = [&](HeapPosition position) { one = one && within(position, top); };
  each_difference(a, b, check);
  each_difference(b, a, check);
  if (!one) {
    return std::nullopt;
  }
  TreeDifference out{.position = top};
  const RayNode* in_a = node_at(a, top);
  const RayNode* in_b = node_at(b, top);
  if (in_a != nullptr) {
    out.a = in_a->surface;
  }
  if (in_b != nullptr) {
    out.b = in_b->surface;
  }
  if (out.a == out.b) {
    const LightMask apart = in_a->lights ^ in_b->lights;
    if (std::popcount(apart) != 1) {
      return std::nullopt;
    }
    out.light = std::countr_zero(apart);
    out.lit_in_a = (in_a->lights & apart) != 0;
  }
  return out;
}

}  // namespace raycat
