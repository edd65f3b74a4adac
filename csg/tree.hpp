#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/placed_shape.hpp"
#include "raytree/surface_id.hpp"

namespace raycat {

/// The set operations. `difference` is the first operand minus all others.
enum class Operation { set_union, intersection, difference };

/// A primitive operand: a shape in the world and the ids of its faces, which follow `first_face`
/// without gaps.
struct CsgLeaf {
  PlacedShape shape;
  SurfaceId first_face{};
};

/// A CSG expression, stored flat with operands before their operation, so that its depth costs
/// no stack. Build it bottom up; the node added last is the root.
class CsgTree {
 public:
  enum class NodeId : std::uint32_t {};

  struct Node {
    Operation operation = Operation::set_union;  ///< of inner nodes
    std::uint32_t leaf = no_leaf;                ///< index into `leaves()`, or `no_leaf`
    std::uint32_t parent = no_parent;            ///< index into `nodes()`
    bool subtracted = false;  ///< a subtrahend of its parent, itself a difference
  };

  static constexpr std::uint32_t no_leaf = ~std::uint32_t{0};
  static constexpr std::uint32_t no_parent = ~std::uint32_t{0};

  NodeId add(CsgLeaf leaf);

  /// Throws `std::invalid_argument` if there is no operand, or one already has a parent.
  NodeId add(Operation operation, std::span<const NodeId> operands);

  std::span<const Node> nodes() const noexcept { return nodes_; }
  std::span<const CsgLeaf> leaves() const noexcept { return leaves_; }

  /// Throws `std::invalid_argument` unless exactly one node, the last, has no parent.
  void require_complete() const;

  /// Gives back memory kept for further nodes.
  void shrink_to_fit();

 private:
  std::vector<Node> nodes_;
  std::vector<CsgLeaf> leaves_;
};

}  // namespace raycat
