#pragma once

#include <string>
#include <vector>

#include "io/export/object_mesh.hpp"

namespace raycat {

/// Takes vertices out of the objects' meshes, those that change the surface least first, by the
/// quadric error of Garland & Heckbert (Surface Simplification Using Quadric Error Metrics,
/// SIGGRAPH 1997). No vertex that goes was farther from what is left than `error` times the half
/// diagonal of its object, and its error is at most the square of that. Vertices on borders between
/// faces, between parts and of open meshes stay, so that faces, closedness and orientation do; the
/// others stay where they are or go. Returns a line for each object that is left as it is:
/// its triangles do not make up a manifold, an image tells its faces, or vertices that differ in
/// more than their place meet within a face.
std::vector<std::string> simplify(const SurfaceTable& surfaces, std::vector<ObjectMesh>& objects,
                                  double error);

}  // namespace raycat
