#include "csg/set_bounds.hpp"

#include <cstddef>
#include <limits>

namespace raycat {
namespace {

constexpr Bounds everywhere{.min = glm::dvec3(-std::numeric_limits<double>::infinity()),
                            .max = glm::dvec3(std::numeric_limits<double>::infinity())};

// The node's own bounds from those of its operands, added in order.
void extend(Bounds& node, const CsgTree::Node& operand, const Bounds& bounds, Operation operation) {
  switch (operation) {
    case Operation::set_union:
      node.include(bounds);
      break;
    case Operation::intersection:
      node = intersection(node, bounds);
      break;
    case Operation::difference:
      if (!operand.subtracted) {
        node = bounds;
      }
      break;
  }
}

}  // namespace

std::vector<Bounds> set_bounds(const CsgTree& tree) {
  const auto nodes = tree.nodes();
  std::vector<Bounds> box(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].leaf == CsgTree::no_leaf && nodes[i].operation == Operation::intersection) {
      box[i] = everywhere;
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].leaf != CsgTree::no_leaf) {
      box[i] = tree.leaves()[nodes[i].leaf].shape.bounds();
    }
    if (nodes[i].parent != CsgTree::no_parent) {
      extend(box[nodes[i].parent], nodes[i], box[i], nodes[nodes[i].parent].operation);
    }
  }
  return box;
}

std::vector<Bounds> leaf_reach(const CsgTree& tree, const std::vector<Bounds>& bounds,
                               double margin) {
  const auto nodes = tree.nodes();
  std::vector<Bounds> allowed(nodes.size(), everywhere);
  std::vector<Bounds> reach(tree.leaves().size());
  for (std::size_t i = nodes.size(); i-- > 0;) {  // parents come before their operands
    if (const std::uint32_t parent = nodes[i].parent; parent != CsgTree::no_parent) {
      allowed[i] = allowed[parent];
      // A difference's bounds are those of what it is cut from, which limit it already.
      if (nodes[parent].operation == Operation::intersection || nodes[i].subtracted) {
        const Bounds& box = bounds[parent];
        allowed[i] = intersection(allowed[i], {.min = box.min - margin, .max = box.max + margin});
      }
    }
    if (nodes[i].leaf != CsgTree::no_leaf) {
      reach[nodes[i].leaf] = intersection(allowed[i], bounds[i]);
    }
  }
  return reach;
}

}  // namespace raycat
