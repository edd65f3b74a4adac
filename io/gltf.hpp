#pragma once

#include <filesystem>

#include "io/scene_file.hpp"

namespace raycat {

/// Reads a glTF 2.0 file, .gltf or .glb, with raycat's extras (DESIGN 4). Throws `LoadError`.
SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace raycat
