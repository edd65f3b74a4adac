#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/export/object_mesh.hpp"

namespace raycat {

/// Writes the objects of a scene as binary glTF: a node for each, named as it is, with a primitive
/// for each material, and EXT_mesh_features ids that say which face each vertex is of. The mesh's
/// extras name them:
///
///     {"raycat": {"object": "plate", "primitives": [{"name": "hole", "faces": 3}, ...],
///                 "features": [[primitive, face], ...]}}
///
/// so that reading the file gives the same objects, primitives and faces again. Lone half-spaces,
/// materials, lights of eq. (1), cameras and surroundings are kept by our own extras. Adds a line
/// to `warnings` for each thing that is not. Throws `std::runtime_error` if the file cannot be
/// written, and `std::length_error` if the scene is too large for the format.
void write_glb(const std::filesystem::path& path, const Scene& scene,
               std::span<const ObjectMesh> objects, std::vector<std::string>& warnings);

}  // namespace raycat
