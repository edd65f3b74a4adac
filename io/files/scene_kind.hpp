#pragma once

#include <filesystem>

namespace raycat {

/// The kinds of files that scenes are read from, and what is none of them.
enum class SceneKind { gltf, csg, scad, obj, ply, stl, off, other };

/// The kind of `file`, told by its extension, or of a GLB by its first bytes. Whoever is handed the
/// kind does not ask again.
SceneKind scene_kind(const std::filesystem::path& file);

}  // namespace raycat
