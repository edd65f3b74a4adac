#pragma once

#include <cstdint>
#include <vector>

#include "csg/tree.hpp"
#include "geometry/mesh.hpp"

namespace raycat {

/// How finely curved shapes become triangles.
struct TessellationRule {
  /// How far a triangle may be from the curved surface, relative to the half diagonal of the
  /// bounds of the tree's leaves.
  double chord_error = 1e-3;
};

/// What a CSG tree comes to. Face k of the mesh is what `origins[k]` left of itself.
struct EvaluatedMesh {
  struct Origin {
    std::uint32_t leaf = 0;  ///< index into the tree's `leaves()`
    std::uint32_t face = 0;  ///< of that leaf
    bool operator==(const Origin&) const = default;
  };

  TriangleMesh mesh;
  std::vector<Origin> origins;  ///< ascending by leaf, then face
};

/// The boundary of a CSG tree as triangles, counter-clockwise from outside: every edge is shared
/// by as many triangles that run along it one way as the other, and where solids touch along an
/// edge these are more than two. Where operands' surfaces coincide, the rule of `Solid` says whose
/// face it is. No triangles if the tree comes to nothing.
///
/// Faces of two leaves that coincide (`coincident_leaves`) are first put into one plane, so that
/// what is meant to be flush is, where rays have it so. The rest is exact, until the corners that
/// have come about are rounded to doubles.
///
/// Throws `std::invalid_argument` if a half-space leaves the tree without bounds, if the tree is
/// not complete, or if the operands take too many triangles, `std::length_error` if these cut one
/// another too often, and `std::runtime_error` if raycat was built without CGAL.
EvaluatedMesh evaluate(const CsgTree& tree, const TessellationRule& rule = {});

}  // namespace raycat
