#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid.hpp"
#include "csg/tree.hpp"
#include "geometry/coincident_surfaces.hpp"
#include "geometry/crossing.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// What `Solid` is checked against: the same boundaries by the plain way, that looks at every leaf,
/// counts the true operands of every node and walks up the tree from each leaf that changes.
class LinearSolid {
 public:
  /// Buffers that a thread reuses from ray to ray, for any solids.
  struct Scratch;

  /// Throws `std::invalid_argument` as `CsgTree::require_complete` does.
  explicit LinearSolid(CsgTree tree);

  /// Sets `scratch.boundaries` to all passages through the boundary along the whole line, in
  /// ascending t, entering and leaving in turn. Returns whether the line is inside at
  /// t -> -infinity.
  bool cross(const Ray& ray, Scratch& scratch) const;

 private:
  // A node as a threshold gate: it is true when at least `threshold` of its inputs are.
  struct Gate {
    std::uint32_t parent = CsgTree::no_parent;
    std::uint32_t threshold = 1;
    bool negated = false;     // counts for its parent where it is false
    bool subtracted = false;  // an odd number of negations up to the root
  };

  double group_size(const Ray& ray) const;  // in scene units
  void gather(const Ray& ray, Scratch& scratch) const;
  bool toggle(std::uint32_t leaf, Scratch& scratch) const;
  void report_group(std::size_t begin, std::size_t end, Scratch& scratch) const;
  bool inside(const Scratch& scratch) const;

  CsgTree tree_;
  double extent_ = 1.0;
  CoincidentSurfaces coincident_{{}, 0.0};
  std::vector<Gate> gates_;  // one a node
  std::vector<std::uint32_t> leaf_node_;
  std::vector<std::uint32_t> true_inputs_;  // of each node while every leaf is false
};

struct LinearSolid::Scratch {
  std::vector<Boundary> boundaries;

 private:
  friend class LinearSolid;

  struct Event {
    double t = 0.0;
    std::uint32_t leaf = 0;
    std::uint32_t crossing = 0;
  };

  Crossings crossings_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> true_inputs_;  // of each node at this point of the line
  std::vector<std::uint8_t> changed_;       // did the node change across the group?
  std::vector<std::uint32_t> touched_;      // nodes whose `changed` has been written
};

}  // namespace raycat
