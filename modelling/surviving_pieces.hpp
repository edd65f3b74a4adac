#pragma once

#include <cstdint>
#include <vector>

#include "csg/tree.hpp"
#include "modelling/arrangement.hpp"
#include "modelling/leaf_triangles.hpp"

namespace raycat {

enum class Survival : std::uint8_t { gone, as_is, turned };

/// Which pieces of the leaves' triangles are the boundary of the solid, and which of these have
/// the solid in front of them, as subtracted surfaces do. Of pieces at one place it is the one
/// whose triangle is of the surface that `Solid` would report.
std::vector<Survival> surviving_pieces(const CsgTree& tree, const LeafTriangles& leaves,
                                       const Arrangement& arrangement);

}  // namespace raycat
