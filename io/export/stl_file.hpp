#pragma once

#include <filesystem>
#include <span>

#include "io/export/object_mesh.hpp"

namespace raycat {

/// Writes all objects as one binary STL, in single precision. Names, faces and materials are lost.
/// Throws `std::runtime_error` if the file cannot be written.
void write_stl(const std::filesystem::path& path, std::span<const ObjectMesh> objects);

}  // namespace raycat
