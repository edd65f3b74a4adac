#pragma once

#include "csg/tree.hpp"
#include "geometry/bounds.hpp"
#include "geometry/coincident_surfaces.hpp"

namespace raycat {

/// A box around the leaves that are bounded. `coincidence_tolerance` of it is how far apart the
/// faces of leaves may be and still coincide.
Bounds bounded_leaves(const CsgTree& tree);

/// Where surfaces of the leaves coincide; the parts are the leaves, by index. Everything that
/// evaluates the tree asks this, so that rays and meshes have the same faces coincide. A lone leaf
/// is as it is.
CoincidentSurfaces coincident_leaves(const CsgTree& tree);

}  // namespace raycat
