#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "csg/heavy_paths.hpp"
#include "csg/leaf_bvh.hpp"
#include "csg/packed_leaves.hpp"
#include "csg/tree.hpp"
#include "geometry/bounds.hpp"
#include "geometry/coincident_surfaces.hpp"
#include "geometry/crossing.hpp"
#include "geometry/line_clip.hpp"
#include "geometry/ray.hpp"
#include "raytree/surface_id.hpp"

namespace raycat {

/// One passage of a line through the boundary of a solid.
struct Boundary {
  double t = 0.0;           ///< in units of the ray's direction
  std::uint32_t leaf = 0;   ///< the responsible leaf, an index into the tree's `leaves()`
  std::uint32_t face = 0;   ///< of that leaf, from 0
  std::uint32_t piece = 0;  ///< of its surface, as `Crossing::piece`
  bool entering = true;     ///< does the line go into the solid here?
  bool subtracted = false;  ///< does the leaf's solid lie on the outer side?
  glm::dvec3 normal{0.0};   ///< of the leaf's shape, in the shape's frame; see `Solid::normal`
};

/// The boundary of a CSG tree, for rays. A lone shape is a tree of one leaf.
///
/// Evaluated by events on the whole line (docs/design.md, Rays through CSG): the crossings of all
/// leaves that the line comes by where they matter are sorted; the leaves they belong to change
/// sides, the change goes up the tree, and where the root changes a boundary is reported. Crossings
/// of faces that coincide are at one place, where the line passes through the surface that they
/// share, whatever the line's direction (Coincident surfaces): they leave no skin. Crossings at one
/// place, but for rounding, are a group, whose leaves change sides at once. Of
/// the leaves in a group, those are responsible that changed across the group together with all
/// their ancestors; the boundary is the one with the least (is subtracted, surface id) among them,
/// whatever the operands' order.
class Solid {
 public:
  /// Buffers that a thread reuses from ray to ray, for any solids.
  struct Scratch;

  /// Throws `std::invalid_argument` as `CsgTree::require_complete` does.
  explicit Solid(CsgTree tree);

  /// Sets `scratch.boundaries` to all passages through the boundary along the whole line, in
  /// ascending t, entering and leaving in turn. Returns whether the line is inside at
  /// t -> -infinity.
  bool cross(const Ray& ray, Scratch& scratch) const;

  /// The first passage past `begin` and before `end`, if there is one: that of `cross`, for less.
  /// Leaves that the line meets only behind `begin` or past the passage are not looked at.
  /// `scratch.boundaries` is left with anything.
  std::optional<Boundary> first(const Ray& ray, double begin, double end, Scratch& scratch) const;

  /// The passage after the one that `first` or `next` found last with this scratch, if it is before
  /// the `end` that `first` was given.
  std::optional<Boundary> next(Scratch& scratch) const;

  /// The unit normal in the world, out of the final solid: a subtracted surface's is flipped.
  glm::dvec3 normal(const Boundary& boundary) const noexcept;

  SurfaceId surface(const Boundary& boundary) const noexcept {
    return SurfaceId{static_cast<std::uint32_t>(tree_.leaves()[boundary.leaf].first_face) +
                     boundary.face};
  }

  /// Does the leaf's solid lie on the outer side of the boundaries that it makes?
  bool subtracted(std::uint32_t leaf) const noexcept { return paths_.subtracted(leaf); }

  /// A box around the solid, no larger than its operands' boxes make necessary. Infinite sides
  /// if a half-space leaves it unbounded; may be empty.
  const Bounds& bounds() const noexcept { return bounds_; }

  const CsgTree& tree() const noexcept { return tree_; }

 private:
  bool lone() const noexcept { return tree_.leaves().size() == 1 && tree_.nodes().size() == 1; }
  double group_length(const Ray& ray) const;
  double shift(const Ray& ray) const;
  void settle(const Ray& ray, std::uint32_t leaf, std::size_t first, Scratch& scratch) const;
  void add_leaf(const Ray& ray, std::uint32_t leaf, double begin, Scratch& scratch) const;
  std::optional<Boundary> next_of_lone(Scratch& scratch) const;
  std::optional<Boundary> next_of_tree(Scratch& scratch) const;
  void pass_group(Scratch& scratch, std::size_t begin, std::size_t end) const;

  CsgTree tree_;
  double extent_ = 1.0;  // of the coordinates of leaves that are bounded
  CoincidentSurfaces coincident_;
  Bounds bounds_;
  PackedLeaves leaves_;
  HeavyPaths paths_;
  LeafBvh index_;
};

struct Solid::Scratch {
  std::vector<Boundary> boundaries;

 private:
  friend class Solid;

  struct Event {
    double t = 0.0;
    std::uint32_t leaf = 0;
    std::uint32_t crossing = 0;
  };

  Crossings crossings_;
  std::vector<Event> events_;
  std::vector<Event> group_;
  std::vector<std::uint32_t> met_;  // leaves whose boxes the line meets
  double shift_ = 0.0;              // of a crossing, at most

  // From `first` on.
  Ray ray_;
  double length_ = 0.0;  // of a group
  Interval wanted_;
  Interval known_;          // where crossings are looked for
  std::size_t passed_ = 0;  // crossings of a lone shape
  LeafBvh::Search search_;

  HeavyPaths::State state_;
};

}  // namespace raycat
