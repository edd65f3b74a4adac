#pragma once

#include "geometry/mesh.hpp"

namespace raycat {

/// The mesh with equal positions welded, positions that no triangle uses left out, and without
/// the triangles that have two corners at one place; what is left keeps its order. Triangles are
/// cut where the end of an open edge lies exactly on an edge of theirs, if that closes all. Throws
/// `std::invalid_argument` unless it encloses a volume, as `ClosedMesh` says.
TriangleMesh watertight(TriangleMesh mesh);

}  // namespace raycat
