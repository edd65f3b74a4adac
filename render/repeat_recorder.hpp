#pragma once

#include <cstddef>
#include <utility>

#include "raytree/ray_tree.hpp"

namespace raycat {

/// Records a tree against the one before, which most samples repeat: nodes are compared as they
/// come, and stored only from the first that differs. (Stored and compared afterwards, trees cost
/// five times as much, since the processor waits to read what it has just written.)
class RepeatRecorder {
 public:
  void start() {
    matched_ = 0;
    differs_ = false;
  }

  void push_back(const RayNode& node) {
    if (!differs_) {
      // Of the weights too, which `reduce` may go by.
      if (matched_ < tree_.size() && tree_[matched_] == node &&
          tree_[matched_].weight == node.weight) {
        ++matched_;
        return;
      }
      diverge();
    }
    fresh_.push_back(node);
  }

  /// Ends the tree; is it the one before?
  bool repeats() {
    if (!differs_ && matched_ == tree_.size()) {
      return true;
    }
    if (!differs_) {
      diverge();
    }
    std::swap(tree_, fresh_);
    return false;
  }

  const RayTree& tree() const { return tree_; }

 private:
  [[gnu::noinline]] void diverge() {
    differs_ = true;
    fresh_.assign(tree_.begin(), tree_.begin() + static_cast<std::ptrdiff_t>(matched_));
  }

  RayTree tree_;   // the last whole one
  RayTree fresh_;  // the one being recorded, once it differs
  std::size_t matched_ = 0;
  bool differs_ = false;
};

}  // namespace raycat
