#pragma once

#include <filesystem>

#include "io/files/scene_kind.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat {

/// A mesh file as a scene of one object, named for the file: grey, its triangles joined into
/// faces. Throws `LoadError` as `read_mesh_file` does.
SceneFile read_mesh_scene(const std::filesystem::path& file, SceneKind kind,
                          const LoadOptions& options);

}  // namespace raycat
