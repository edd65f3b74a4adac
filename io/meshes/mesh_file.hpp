#pragma once

#include <filesystem>

#include "geometry/mesh.hpp"
#include "io/files/scene_kind.hpp"

namespace raycat {

/// Reads the triangles of a .obj, .ply, .stl or .off file through OpenMesh; polygons are
/// triangulated. Triangles that OpenMesh drops as not manifold are kept. The faces are left
/// empty: `group_faces` makes them. Throws `LoadError` for a file that is missing, not of its
/// `kind`, truncated, holds no triangle, an index out of range or a coordinate that is not finite.
TriangleMesh read_mesh_file(const std::filesystem::path& file, SceneKind kind);

}  // namespace raycat
