#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/gltf/assets.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat {

/// Reads the default scene of a glTF file, or only the node named `node` and what is below it.
/// Throws `LoadError`.
SceneFile read_gltf_scene(const std::filesystem::path& file, const std::optional<std::string>& node,
                          GltfAssets& assets);

}  // namespace raycat
