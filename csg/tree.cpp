#include "csg/tree.hpp"

#include <stdexcept>
#include <utility>

namespace raycat {

CsgTree::NodeId CsgTree::add(CsgLeaf leaf) {
  nodes_.push_back({.leaf = static_cast<std::uint32_t>(leaves_.size())});
  leaves_.push_back(std::move(leaf));
  return NodeId{static_cast<std::uint32_t>(nodes_.size() - 1)};
}

CsgTree::NodeId CsgTree::add(Operation operation, std::span<const NodeId> operands) {
  if (operands.empty()) {
    throw std::invalid_argument("a set operation needs at least one operand");
  }
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  for (const NodeId operand : operands) {
    Node& node = nodes_.at(static_cast<std::size_t>(operand));
    if (node.parent != no_parent) {
      throw std::invalid_argument("an operand belongs to two set operations");
    }
    node.parent = id;
    node.subtracted = operation == Operation::difference && operand != operands.front();
  }
  nodes_.push_back({.operation = operation});
  return NodeId{id};
}

void CsgTree::require_complete() const {
  if (nodes_.empty()) {
    throw std::invalid_argument("a CSG tree needs at least one operand");
  }
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
    if (nodes_[i].parent == no_parent) {
      throw std::invalid_argument("an operand belongs to no set operation");
    }
  }
}

void CsgTree::shrink_to_fit() {
  nodes_.shrink_to_fit();
  leaves_.shrink_to_fit();
}

}  // namespace raycat
