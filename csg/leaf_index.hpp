#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bounds.hpp"
#include "geometry/line_clip.hpp"

namespace raycat {

/// A bounding volume hierarchy of boxes, for finding those that a line meets. Flat and in
/// preorder, each node with the place to go on at if it is missed, so that neither building nor
/// visiting needs a stack as deep as it.
class LeafIndex {
 public:
  /// Empty boxes are never met, unbounded ones always.
  explicit LeafIndex(std::span<const Bounds> boxes);

  /// Calls `met(i, interval)` for each box that meets `window` of the line, with the part of the
  /// window in box `i`. In no particular order.
  template <typename Met>
  void visit(const LineClip& clip, const Interval& window, Met&& met) const {
    for (const std::uint32_t box : unbounded_) {
      met(box, window);
    }
    for (std::uint32_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      if (clip(node.bounds, window).empty()) {
        i = node.skip;
        continue;
      }
      for (std::uint32_t k = node.begin; k < node.end; ++k) {
        const Interval inside = clip(entries_[k].bounds, window);
        if (!inside.empty()) {
          met(entries_[k].box, inside);
        }
      }
      ++i;
    }
  }

 private:
  struct Node {
    Bounds bounds;
    std::uint32_t skip = 0;   // the node after all that are below this one
    std::uint32_t begin = 0;  // its own entries, none if it has nodes below
    std::uint32_t end = 0;
  };
  struct Entry {
    Bounds bounds;
    std::uint32_t box = 0;
  };

  void build();
  std::uint32_t split(std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> unbounded_;
};

}  // namespace raycat
