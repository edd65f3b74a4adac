#pragma once

#include <vector>

#include "csg/tree.hpp"
#include "reference/place.hpp"

namespace raycat::reference {

/// A passage through the boundary of a solid.
struct Boundary {
  Real t = 0.0L;
  Vec normal{0.0L};  ///< unit, out of the solid
  bool entering = true;
  std::uint32_t leaf = 0;
  std::uint32_t face = 0;  ///< of the leaf
};

/// The boundary of a set expression, by points: all leaves' passages cut the line into stretches,
/// in each of which the expression is asked what it holds. A passage is where that differs, and
/// belongs to the responsible leaf (docs/design.md, Coincident surfaces).
class SolidPassages {
 public:
  /// Keeps a reference to `tree`.
  explicit SolidPassages(const CsgTree& tree);

  /// Of the whole line, in ascending t.
  std::vector<Boundary> operator()(const Line& line) const;

 private:
  struct Leaf {
    Place place;
    std::size_t node = 0;
    bool subtracted = false;  ///< an odd number of times
    Vec middle{0.0L};         ///< of a ball round a mesh, in the mesh's frame
    Real radius = -1.0L;      ///< of that ball; of others nothing
  };
  struct Event;
  using Sides = std::vector<bool>;  // of each node or leaf: is the point inside?

  // Adds the passages of one leaf; returns whether there are none and all of the line is inside.
  bool add_events(const Line& line, std::uint32_t leaf, std::vector<Event>& events) const;

  // Of the nodes at t. `in_leaf` is of the leaves that the line does not pass.
  Sides sides(const std::vector<Event>& events, Sides in_leaf, Real t) const;
  bool responsible(std::size_t node, const Sides& before, const Sides& after) const;

  const CsgTree& tree_;
  std::vector<Leaf> leaves_;
  Real distance_ = 0.0L;  // below which surfaces are one
};

}  // namespace raycat::reference
