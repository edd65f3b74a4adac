#include "csg/heavy_paths.hpp"

#include <algorithm>
#include <cstddef>

namespace raycat {
namespace {

constexpr std::uint32_t word_bits = 64;

// Is each node under an odd number of complements?
std::vector<std::uint8_t> subtracted_nodes(const CsgTree& tree) {
  const auto nodes = tree.nodes();
  std::vector<std::uint8_t> subtracted(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const bool above = nodes[i].parent != CsgTree::no_parent && subtracted[nodes[i].parent] != 0;
    subtracted[i] = above != nodes[i].subtracted ? 1 : 0;
  }
  return subtracted;
}

// The operand with the most leaves of each inner node, the first of several.
std::vector<std::uint32_t> heavy_operands(const CsgTree& tree) {
  const auto nodes = tree.nodes();
  std::vector<std::uint32_t> leaves(nodes.size());
  std::vector<std::uint32_t> heavy(nodes.size(), CsgTree::no_parent);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    leaves[i] += nodes[i].leaf != CsgTree::no_leaf ? 1u : 0u;
    if (const std::uint32_t parent = nodes[i].parent; parent != CsgTree::no_parent) {
      leaves[parent] += leaves[i];
      if (heavy[parent] == CsgTree::no_parent || leaves[i] > leaves[heavy[parent]]) {
        heavy[parent] = static_cast<std::uint32_t>(i);
      }
    }
  }
  return heavy;
}

}  // namespace

HeavyPaths::HeavyPaths(const CsgTree& tree) {
  const std::vector<std::uint8_t> subtracted = subtracted_nodes(tree);
  lay_out(tree);
  set_up(tree, subtracted);
  summarize();
  slot_of_node_ = {};
}

void HeavyPaths::lay_out(const CsgTree& tree) {
  constexpr std::uint32_t none = CsgTree::no_parent;
  const auto nodes = tree.nodes();
  const std::vector<std::uint32_t> heavy = heavy_operands(tree);
  std::vector<std::uint32_t> light(nodes.size(), none);  // the first light operand of each node,
  std::vector<std::uint32_t> next(nodes.size(), none);   // and the next one of its parent
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    if (const std::uint32_t parent = nodes[i].parent; heavy[parent] != i) {
      next[i] = light[parent];
      light[parent] = static_cast<std::uint32_t>(i);
    }
  }
  slot_of_node_.resize(nodes.size());
  places_.reserve(nodes.size());
  std::vector<std::uint32_t> tops{static_cast<std::uint32_t>(nodes.size() - 1)};
  while (!tops.empty()) {
    std::uint32_t node = tops.back();
    tops.pop_back();
    const std::uint32_t parent = nodes[node].parent;
    const Place place{.top = static_cast<std::uint32_t>(places_.size()),
                      .parent = parent == none ? no_slot : slot_of_node_[parent]};
    for (; node != none; node = heavy[node]) {
      slot_of_node_[node] = static_cast<std::uint32_t>(places_.size());
      places_.push_back(place);
      for (std::uint32_t operand = light[node]; operand != none; operand = next[operand]) {
        tops.push_back(operand);
      }
    }
  }
}

void HeavyPaths::set_up(const CsgTree& tree, const std::vector<std::uint8_t>& subtracted) {
  const auto nodes = tree.nodes();
  slot_of_leaf_.resize(tree.leaves().size());
  leaf_subtracted_.resize(tree.leaves().size());
  std::vector<std::uint8_t> value_below(nodes.size());  // of the next slot of the path
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t slot = slot_of_node_[i];
    bool value = false;
    if (nodes[i].leaf != CsgTree::no_leaf) {
      places_[slot].kind = Kind::leaf;
      slot_of_leaf_[nodes[i].leaf] = slot;
      leaf_subtracted_[nodes[i].leaf] = subtracted[i];
      places_[slot].initial = subtracted[i];
      value = subtracted[i] != 0;
    } else {
      // By De Morgan, a union is an intersection of complements.
      const bool any = (nodes[i].operation == Operation::set_union) != (subtracted[i] != 0);
      places_[slot].kind = any ? Kind::any : Kind::all;
      value = places_[slot].initial > 0 ? any : value_below[slot] != 0;
    }
    if (nodes[i].parent == CsgTree::no_parent) {
      continue;
    }
    const std::uint32_t parent = slot_of_node_[nodes[i].parent];
    if (places_[parent].top == places_[slot].top) {
      value_below[parent] = value ? 1 : 0;
    } else {
      const bool parent_subtracted = subtracted[nodes[i].parent] != 0;
      const bool parent_any =
          (nodes[nodes[i].parent].operation == Operation::set_union) != parent_subtracted;
      places_[parent].initial += value == parent_any ? 1u : 0u;
    }
  }
}

void HeavyPaths::summarize() {
  auto count = static_cast<std::uint32_t>(places_.size());
  std::uint32_t below = 0;
  for (bool first = true; first || count > 1; first = false) {
    const auto begin = static_cast<std::uint32_t>(words_.size());
    level_begin_.push_back(begin);
    words_.resize(begin + (count + word_bits - 1) / word_bits);
    for (std::uint32_t i = 0; i < count; ++i) {
      const bool set =
          first ? places_[i].kind == Kind::leaf || places_[i].initial > 0 : words_[below + i] != 0;
      words_[begin + i / word_bits] |= std::uint64_t{set} << i % word_bits;
    }
    below = begin;
    count = static_cast<std::uint32_t>(words_.size()) - begin;
  }
}

}  // namespace raycat
