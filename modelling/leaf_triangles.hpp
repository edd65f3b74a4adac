#pragma once

#include <cstdint>
#include <vector>

#include "csg/tree.hpp"
#include "geometry/mesh.hpp"
#include "modelling/evaluate.hpp"
#include "modelling/exact.hpp"

namespace raycat {

/// The leaves of a tree as triangles, each leaf's closing a volume. Half-spaces end outside of
/// everything that is bounded.
struct LeafTriangles {
  glm::dmat3 frame{1.0};                ///< what takes all positions to the world
  TriangleMesh mesh;                    ///< faces are those of the leaf; positions are rounded
  std::vector<Exact::Point_3> corners;  ///< the positions
  std::vector<std::uint32_t> leaf;      ///< of each triangle
  std::vector<std::uint8_t> wanted;     ///< may part of the triangle be the solid's boundary?
};

/// Throws as `evaluate` does. No triangles if the tree comes to nothing.
LeafTriangles leaf_triangles(const CsgTree& tree, const TessellationRule& rule);

}  // namespace raycat
