#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh.hpp"
#include "io/files/scene_kind.hpp"

namespace raycat {

/// What a mesh file holds. The faces are left empty: `group_faces` makes them.
struct MeshFile {
  TriangleMesh triangles;
  std::string warning;  ///< of what is odd in the file; empty if nothing is
};

/// Reads the triangles of a .obj, .ply, .stl or .off file; polygons are triangulated, and corners
/// of an STL file at the same place are one. Throws `LoadError` for a file that is missing, not of
/// its `kind`, truncated, holds no triangle, an index out of range or a coordinate that is not
/// finite as a `float`.
MeshFile read_mesh_file(const std::filesystem::path& file, SceneKind kind);

}  // namespace raycat
