#pragma once

#include <filesystem>

#include "io/scene/scene_file.hpp"

namespace raycat {

/// Reads a scene file, its kind told by content and extension: glTF 2.0 (.gltf, .glb), OpenSCAD
/// CSG (.csg, .scad), or a mesh (.obj, .ply, .stl, .off). Throws `LoadError`.
SceneFile load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace raycat
