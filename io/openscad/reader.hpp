#pragma once

#include <filesystem>

#include "io/files/scene_kind.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat {

/// Reads an OpenSCAD .csg file: the tree that OpenSCAD dumps, or a person writes; or a .scad file,
/// if the `openscad` program is there to make that tree. Throws `LoadError`, naming line and node.
SceneFile read_openscad(const std::filesystem::path& file, SceneKind kind,
                        const LoadOptions& options);

}  // namespace raycat
