#pragma once

#include <cstddef>
#include <vector>

#include <glm/mat3x2.hpp>

#include "io/gltf_document.hpp"
#include "tracer/material.hpp"
#include "tracer/texture.hpp"

namespace raycat {

/// glTF's PBR parameters in the paper's constants, by the table of DESIGN 9, or the `whitted`
/// extras that give them outright. Only factors decide k_s and k_t, never textures.
struct GltfMaterial {
  Material material;                    ///< its `base_texture` not yet set
  std::optional<std::size_t> texture;   ///< of the base colour, an index into glTF's textures
  std::size_t coordinates = 0;          ///< which TEXCOORD_n the texture is looked up with
  glm::dmat3x2 texture_transform{1.0};  ///< KHR_texture_transform: onto (u, v, 1)
};

/// The materials of a document, their images decoded into `textures`. Throws `LoadError` for
/// extensions and extras of the wrong type, and unknown keys in `whitted`. glTF's factors are
/// brought into their ranges, with a warning.
std::vector<GltfMaterial> read_materials(GltfDocument& document, std::vector<Texture>& textures,
                                         LoadBudget& budget);

/// What glTF says of primitives without a material, and of shapes: rough and white.
Material default_material();

/// Decodes the base colour textures that `materials` use and sets their `base_texture`. An image
/// that is missing or broken is a warning, and its materials stay untextured.
std::vector<Texture> read_textures(GltfDocument& document, std::vector<GltfMaterial>& materials,
                                   LoadBudget& budget);

}  // namespace raycat
