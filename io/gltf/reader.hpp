#pragma once

#include <filesystem>

#include "io/gltf/assets.hpp"

namespace raycat {

/// Reads a glTF 2.0 file, .gltf or .glb, with raycat's extras (docs/scene-files.md); `read_other`
/// reads files of other kinds that its nodes place. Throws `LoadError`.
SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options,
                    const OtherReader& read_other);

}  // namespace raycat
