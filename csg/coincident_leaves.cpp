#include "csg/coincident_leaves.hpp"

#include <cstddef>
#include <variant>
#include <vector>

#include "csg/set_bounds.hpp"

namespace raycat {
namespace {

// For each box, one around all others.
std::vector<Bounds> around_others(const std::vector<Bounds>& boxes) {
  std::vector<Bounds> others(boxes.size());
  Bounds before;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    others[i] = before;
    before.include(boxes[i]);
  }
  Bounds after;
  for (std::size_t i = boxes.size(); i-- > 0;) {
    others[i].include(after);
    after.include(boxes[i]);
  }
  return others;
}

}  // namespace

Bounds bounded_leaves(const CsgTree& tree) {
  Bounds all;
  for (const CsgLeaf& leaf : tree.leaves()) {
    if (leaf.shape.bounds().finite()) {
      all.include(leaf.shape.bounds());
    }
  }
  return all;
}

CoincidentSurfaces coincident_leaves(const CsgTree& tree) {
  const Bounds whole = bounded_leaves(tree);
  const double tolerance = coincidence_tolerance(whole);
  CoincidentSurfaces surfaces(whole, tolerance);
  if (tree.leaves().size() < 2) {
    return surfaces;
  }
  const std::vector<Bounds> reach = leaf_reach(tree, set_bounds(tree), 4.0 * tolerance);
  const std::vector<Bounds> others = around_others(reach);
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const PlacedShape& shape = tree.leaves()[i].shape;
    Bounds where = reach[i];
    if (std::holds_alternative<MeshShape>(shape.shape())) {  // most of it is by itself, often
      const Bounds near{.min = others[i].min - tolerance, .max = others[i].max + tolerance};
      where = intersection(where, near);
    }
    surfaces.add(shape, where);
  }
  surfaces.find();
  return surfaces;
}

}  // namespace raycat
