#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/prefetch.hpp"
#include "csg/tree.hpp"

namespace raycat {

/// A CSG tree cut into heavy paths, for following the root's value while leaves change sides one
/// by one, in O(log N) paths a change however deep the tree is (docs/design.md, Rays through CSG).
///
/// Complements are pushed down to the leaves: every inner node is then true when any (a union), or
/// when all (an intersection), of its operands are, and a subtracted leaf is true on its outside. A
/// path leads from its top to a leaf by the operand with the most leaves; the other, light operands
/// are tops of paths of their own. A node is *decided* while a light operand alone fixes its value:
/// a true one of a union, a false one of an intersection. Otherwise it is as the next node on its
/// path, so the top's value is that of the path's first decided node, the leaf if there is none.
class HeavyPaths {
 public:
  /// What one thread follows, and reuses for any trees. Starting again costs nothing that grows
  /// with the tree: what was written is told by its stamp from what is still as at the start.
  class State;

  /// The tree must be complete.
  explicit HeavyPaths(const CsgTree& tree);

  /// Is the leaf's outside on the solid's side: is it under an odd number of complements?
  bool subtracted(std::uint32_t leaf) const noexcept { return leaf_subtracted_[leaf] != 0; }

  /// For `State::prefetch`.
  void prefetch(std::uint32_t leaf) const noexcept { raycat::prefetch(&slot_of_leaf_[leaf]); }

 private:
  enum class Kind : std::uint8_t { all, any, leaf };

  // What does not change about a node, together, so that climbing by a node waits for memory once.
  struct Place {
    std::uint32_t top = 0;     // of its path, a slot
    std::uint32_t parent = 0;  // the slot of the top's parent, or `no_slot`
    // While every leaf is outside: how many light operands decide a node; whether a leaf is true.
    std::uint32_t initial = 0;
    Kind kind = Kind::leaf;
  };

  static constexpr std::uint32_t no_slot = ~std::uint32_t{0};

  void lay_out(const CsgTree& tree);
  void set_up(const CsgTree& tree, const std::vector<std::uint8_t>& subtracted);
  void summarize();

  // Nodes by slot: path by path, and down each path; after it those that end at it, the lowest
  // first. What is near in the tree is near in memory.
  std::vector<Place> places_;
  std::vector<std::uint32_t> slot_of_node_;  // while building
  std::vector<std::uint32_t> slot_of_leaf_;
  std::vector<std::uint8_t> leaf_subtracted_;
  // A bit a slot, set for leaves and decided nodes; above it, level by level, a bit a word: is any
  // bit of the word set? All levels one after the other, the last of one word.
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> level_begin_;
};

class HeavyPaths::State {
 public:
  /// Puts every leaf outside.
  void start(const HeavyPaths& paths);

  /// Changes the side of a leaf. Returns whether the root's value changed.
  bool toggle(std::uint32_t leaf);
  /// For `toggle`.
  void prefetch(std::uint32_t leaf) const noexcept {
    const std::uint32_t slot = paths_->slot_of_leaf_[leaf];
    raycat::prefetch(&paths_->places_[slot]);
    raycat::prefetch(&slots_[slot]);
  }

  /// Is a point on these sides of the leaves in the solid?
  bool inside() const;

  bool leaf_inside(std::uint32_t leaf) const;

  /// From here on until `end_group`, changes are taken together.
  void begin_group();
  void end_group();

  /// Did the leaf, and every node above it, change from the last `begin_group` to its `end_group`?
  bool responsible(std::uint32_t leaf) const;

 private:
  struct Slot {
    std::uint32_t start = 0;  // what follows is of this start
    std::uint32_t count = 0;  // as `Place::initial`
    std::uint32_t group = 0;  // in which the node was last written
  };
  struct Word {
    std::uint32_t start = 0;
    std::uint64_t bits = 0;
  };
  // A leaf that changed sides, or a node that became decided or undecided, in the group.
  struct Touched {
    std::uint32_t slot = 0;
    bool decided = false;  // at the group's begin
    bool before = false;   // the node's value then, and now
    bool after = false;
  };
  struct Reach {
    std::uint32_t top = 0;   // of a path
    std::uint32_t last = 0;  // all nodes of the path that were touched, to this one, changed
  };

  Slot& at(std::uint32_t slot);
  std::uint32_t count(std::uint32_t slot) const;
  std::uint64_t bits(std::uint32_t word) const;
  Word& word(std::uint32_t index);
  void set_decided(std::uint32_t slot, bool decided);
  std::uint32_t next_decided(std::uint32_t slot) const;
  bool value_if_decided(std::uint32_t slot) const;
  void touch(std::uint32_t slot, bool decided);
  void compare(std::span<Touched> path);
  void reach(std::span<const Touched> path);

  const HeavyPaths* paths_ = nullptr;
  std::uint32_t start_ = 0;
  std::uint32_t group_ = 0;
  bool in_group_ = false;
  std::vector<Slot> slots_;
  std::vector<Word> words_;
  std::vector<Touched> touched_;
  std::vector<Reach> reaches_;  // by top
};

}  // namespace raycat
