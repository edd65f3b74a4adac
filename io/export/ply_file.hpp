#pragma once

#include <filesystem>
#include <span>

#include "io/export/object_mesh.hpp"

namespace raycat {

/// Writes the objects of a scene as one binary PLY in double precision. Each triangle has the
/// properties `object`, `primitive` and `face`, the first two numbered through the scene and the
/// last within its primitive; comments give the names that belong to the numbers. Throws
/// `std::runtime_error` if the file cannot be written, or has too many vertices.
void write_ply(const std::filesystem::path& path, const SurfaceTable& surfaces,
               std::span<const ObjectMesh> objects);

}  // namespace raycat
