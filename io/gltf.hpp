#pragma once

#include <filesystem>

#include "io/scene_file.hpp"

namespace raycat {

/// Is `file`, which must be regular, glTF by its extension or a GLB by its first bytes?
bool is_gltf(const std::filesystem::path& file);

/// Reads a glTF 2.0 file, .gltf or .glb, with raycat's extras (DESIGN 4). Throws `LoadError`.
SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace raycat
