#pragma once

#include <filesystem>
#include <span>

#include "io/export/object_mesh.hpp"

namespace raycat {

/// Writes the objects of a scene as Wavefront OBJ, coordinates to the last bit: an `o` for each
/// object, and a group `object/primitive/face` for each face. Throws `std::runtime_error` if the
/// file cannot be written.
void write_obj(const std::filesystem::path& path, const SurfaceTable& surfaces,
               std::span<const ObjectMesh> objects);

}  // namespace raycat
