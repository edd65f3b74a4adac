#pragma once

#include <string>

#include "geometry/mesh.hpp"

namespace raycat {

/// What OpenSCAD makes of a .csg text, all of one face.
TriangleMesh openscad_mesh(const std::string& csg);

/// Whether the program is there. Warns that the test is skipped, if not.
bool openscad_is_installed();

struct RayComparison {
  int rays = 0;
  int bad = 0;  ///< those on which the thickness or the first hit differs by 1e-4 half diagonals
};

/// Sends a grid of rays along each axis through both.
RayComparison compare(const ClosedMesh& mesh, const ClosedMesh& reference);

double volume(const TriangleMesh& mesh);

}  // namespace raycat
