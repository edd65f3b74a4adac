#pragma once

#include <vector>

#include "io/gltf/document.hpp"
#include "io/gltf/textures.hpp"
#include "io/scene/scene_file.hpp"
#include "tracer/material.hpp"

namespace raycat {

/// glTF's PBR parameters in the paper's constants, by the table of docs/materials.md, or the
/// `whitted` extras that give them outright. Only factors decide k_s and k_t, never textures.
struct GltfMaterial {
  Material material;
  CoordinateSets coordinates;  ///< that its textures are looked up with
};

/// The materials of a document, their images decoded into the textures. Throws `LoadError` for
/// extensions and extras of the wrong type, and unknown keys in `whitted`. glTF's factors are
/// brought into their ranges, with a warning.
std::vector<GltfMaterial> read_materials(GltfDocument& document, GltfTextures& textures,
                                         BackFaces back_faces);

/// What glTF says of primitives without a material, and of shapes: rough and white.
Material default_material(BackFaces back_faces);

}  // namespace raycat
