#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "csg/tree.hpp"
#include "geometry/placed_shape.hpp"
#include "io/openscad/kind.hpp"
#include "io/openscad/parser.hpp"

namespace raycat::openscad {

/// What a node of the file comes to.
struct Item {
  Kind kind = Kind::unite;
  std::uint8_t dimension = 0;          ///< 2 or 3; 0 for nothing at all
  bool usable = false;                 ///< has it volume?
  std::optional<std::uint32_t> solid;  ///< the shape that the whole node is, by number
  std::optional<glm::vec3> colour;     ///< sRGB, as in the file
  Bounds bounds;                       ///< of usable nodes; no smaller than the geometry
};

/// The file's nodes, one item for each, and the shapes they stand for. A shape stands in the frame
/// of the nearest node above it that is no set operation: such a node works on its operands as
/// they are in its own frame, and is itself a shape then.
struct Items {
  std::span<const Node> nodes;
  std::vector<Item> items;
  std::vector<PlacedShape> shapes;
};

/// Adds the usable node `at` with all that is usable below it to `tree`, and returns its root. A
/// union within a union adds its operands to it, and an operation on one operand is that operand.
/// `leaf(i)` makes the leaf of node i, whose shape is known.
template <typename MakeLeaf>
CsgTree::NodeId add_tree(const Items& from, std::uint32_t at, CsgTree& tree, const MakeLeaf& leaf) {
  struct Open {
    std::uint32_t end = 0;
    Operation operation = Operation::set_union;
    std::vector<CsgTree::NodeId> operands;
  };
  const auto close = [&](const Open& open) {
    return open.operands.size() == 1 ? open.operands.front()
                                     : tree.add(open.operation, open.operands);
  };
  const std::uint32_t end = from.nodes[at].end;
  std::vector<Open> open{{.end = end}};
  while (at < end) {
    const Item& item = from.items[at];
    if (!item.usable) {
      at = from.nodes[at].end;
    } else if (item.solid) {
      open.back().operands.push_back(tree.add(leaf(at)));
      at = from.nodes[at].end;
    } else {
      const Operation operation = item.kind == Kind::subtract    ? Operation::difference
                                  : item.kind == Kind::intersect ? Operation::intersection
                                                                 : Operation::set_union;
      if (operation != Operation::set_union || open.back().operation != Operation::set_union) {
        open.push_back({.end = from.nodes[at].end, .operation = operation});
      }
      ++at;
    }
    while (open.size() > 1 && open.back().end <= at) {
      const CsgTree::NodeId closed = close(open.back());
      open.pop_back();
      open.back().operands.push_back(closed);
    }
  }
  return close(open.back());
}

}  // namespace raycat::openscad
