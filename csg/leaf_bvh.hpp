#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "csg/prefetch.hpp"
#include "geometry/bounds.hpp"
#include "geometry/line_clip.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// A bounding volume hierarchy of boxes, for finding those that a line meets. Four children a node,
/// side by side in single precision: two cache lines tell of four boxes. Boxes are larger by what
/// rounding may do, so that one which is met is always found, and by no more than 1e-6 of the half
/// size of the longest side of all of them, so that little else is.
class LeafBvh {
 public:
  class Search;

  /// Empty boxes are never met, unbounded ones always. At most 2^31 boxes.
  explicit LeafBvh(std::span<const Bounds> boxes);

  /// Calls `met(i)` for each box that the line meets. In no particular order.
  template <typename Met>
  void visit(const Ray& ray, Met&& met) const;

 private:
  static constexpr std::size_t width = 4;
  static constexpr std::uint32_t box_bit = 1u << 31;  // a child with it is a box, else a node

  using Lanes = std::array<float, width>;

  struct alignas(64) Node {
    // In the index's frame: min x, y, z, then max x, y, z. Children that are not there are inside
    // out, and no line meets them.
    std::array<Lanes, 6> sides;
    std::array<std::uint32_t, width> child;
  };

  // A line in the index's frame, in which all boxes are within 1 of the origin. It starts at the
  // point of their bounds next to the ray's origin, so that a far one costs no precision, and goes
  // 1 along the axis that it follows most while its t grows by 1.
  struct Line {
    std::array<float, 3> origin;
    std::array<float, 3> inverse;      // of the direction
    std::array<std::uint8_t, 3> near;  // into `Node::sides`, for each axis
    std::array<std::uint8_t, 3> far;
    float begin;  // the part of it that is wanted
    float end;
    double t_origin;  // the ray's t where it starts
    double per_t;     // its t for one of the ray's
  };

  // Where the line is within each child's box, nowhere if `begin` is past `end`.
  struct Meeting {
    Lanes begin;
    Lanes end;
  };

  struct Entry {
    Bounds bounds;
    std::uint32_t box = 0;
  };
  struct Part;

  void build(std::vector<Entry> entries);
  void set_child(Node& node, std::size_t child, const Bounds& box) const;

  // None if the line passes by all boxes.
  std::optional<Line> line(const Ray& ray, const Interval& window) const;
  static Meeting meet(const Line& line, const Node& node) noexcept;

  // Binary splits above a node; and what `visit` has yet to look at, three siblings a level.
  static constexpr std::uint32_t most_splits = 72;
  static constexpr std::size_t most_open = 3 * most_splits + 1;

  Bounds bounds_;  // of all bounded boxes and what was added to them
  glm::dvec3 center_{0.0};
  double scale_ = 1.0;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> unbounded_;
};

/// Finds boxes in the order in which a line comes to them, looking no further than it is asked to.
/// One is reused from line to line.
class LeafBvh::Search {
 public:
  /// Unbounded boxes come first. `index` must outlive the search.
  void start(const LeafBvh& index, const Ray& ray, const Interval& window);

  /// The next box that meets the window, if the line comes to it up to `limit`; boxes behind the
  /// window's begin are come to there.
  std::optional<std::uint32_t> next(double limit);

 private:
  struct Step {
    float t = 0.0f;  // along `line_`
    std::uint32_t child = 0;
  };

  const LeafBvh* index_ = nullptr;
  Line line_{};
  std::vector<Step> steps_;  // a heap, the nearest on top
};

inline LeafBvh::Meeting LeafBvh::meet(const Line& line, const Node& node) noexcept {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled below, in an inner loop.
  Meeting meeting;
  meeting.begin.fill(line.begin);
  meeting.end.fill(line.end);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Lanes& near = node.sides[line.near[axis]];
    const Lanes& far = node.sides[line.far[axis]];
    for (std::size_t k = 0; k < width; ++k) {
      const float in = (near[k] - line.origin[axis]) * line.inverse[axis];
      const float out = (far[k] - line.origin[axis]) * line.inverse[axis];
      meeting.begin[k] = std::max(meeting.begin[k], in);
      meeting.end[k] = std::min(meeting.end[k], out);
    }
  }
  return meeting;
}

template <typename Met>
void LeafBvh::visit(const Ray& ray, Met&& met) const {
  for (const std::uint32_t box : unbounded_) {
    met(box);
  }
  const std::optional<Line> way = line(ray, {});
  if (!way) {
    return;
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a stack, in an inner loop.
  std::array<std::uint32_t, most_open> open;
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    const Meeting meeting = meet(*way, node);
    for (std::size_t k = 0; k < width; ++k) {
      if (!(meeting.begin[k] <= meeting.end[k])) {
        continue;
      }
      if ((node.child[k] & box_bit) != 0) {
        met(node.child[k] & ~box_bit);
      } else {
        prefetch(&nodes_[node.child[k]]);
        prefetch(&nodes_[node.child[k]].child);
        open[count++] = node.child[k];
      }
    }
  }
}

}  // namespace raycat
