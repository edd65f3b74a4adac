#pragma once

#include "geometry/mesh.hpp"
#include "modelling/polygons.hpp"

namespace raycat {

/// What the plane z = 0 cuts out of a closed mesh, faces that lie in the plane included: OpenSCAD's
/// `projection(cut = true)`. Equal positions are taken as one. Overlapping shells are united.
Polygons section(const TriangleMesh& closed);

/// All that lies below or above a triangle: OpenSCAD's `projection(cut = false)`. Looks only at
/// those that face up, which below and above a closed mesh are enough.
Polygons shadow(const TriangleMesh& closed);

}  // namespace raycat
