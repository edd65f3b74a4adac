#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "modelling/polygons.hpp"

namespace raycat {

/// What the plane z = 0 cuts out of a closed mesh: OpenSCAD's `projection(cut = true)`. Faces that
/// lie in the plane belong to it, but not those that `open_faces` says are open: OpenSCAD takes
/// away the surface of what a difference takes away, so that the floor of a pit at z = 0 is a hole
/// where the top of a block is not. Equal positions are taken as one.
Polygons section(const TriangleMesh& closed, const std::vector<bool>& open_faces = {});

/// All that lies below or above a triangle: OpenSCAD's `projection(cut = false)`. Looks only at
/// those that face up, which below and above a closed mesh are enough.
Polygons shadow(const TriangleMesh& closed);

}  // namespace raycat
