#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_uses.hpp"

namespace raycat {

/// Joins each degenerate triangle to one that is not: from edge to edge, and then through vertices
/// for those that have no edge in common with any. Those that reach none are left alone. `edges`
/// are those of the welded triangles.
void spread_over(const std::vector<bool>& degenerate, std::span<const glm::uvec3> welded,
                 const EdgeUses& edges, DisjointSets& faces);

}  // namespace raycat
