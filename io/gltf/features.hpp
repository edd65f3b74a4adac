#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/gltf/document.hpp"
#include "io/gltf/textures.hpp"
#include "tracer/surface_mesh.hpp"

namespace raycat {

/// What the extras that raycat itself writes say of a mesh: which face of which primitive each
/// feature id of EXT_mesh_features stands for (see `write_glb`).
struct FeatureNames {
  struct Primitive {
    std::string name;
    std::uint32_t faces = 0;
  };

  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> faces;  ///< of each feature, counted through all primitives
};

/// Nothing if the mesh has none. Throws `LoadError` where they do not fit together.
std::optional<FeatureNames> feature_names(const GltfDocument& document, std::size_t mesh);

/// Feature ids as numbers of faces. What has no feature shares the last.
struct FeatureIds {
  std::vector<std::uint32_t> numbers;
  std::uint32_t count = 0;  ///< more than every number
};

/// The ids that the first set of EXT_mesh_features gives to the vertices of a primitive, where it
/// does. `vertices` are the vertices asked for, of `count` that there are. Nothing, with a warning
/// in the document, if there are ids that cannot be read.
std::optional<FeatureIds> feature_ids(GltfDocument& document, std::size_t mesh,
                                      std::size_t primitive,
                                      std::span<const std::uint32_t> vertices, std::size_t count);

/// The same where that set is in a texture, whose coordinates are counted among `sets`.
struct TexturedFeatures {
  std::shared_ptr<const FeatureMap> map;
  std::uint32_t count = 0;  ///< more than every face of the map
};
std::optional<TexturedFeatures> feature_map(GltfDocument& document, std::size_t mesh,
                                            std::size_t primitive, GltfTextures& textures,
                                            CoordinateSets& sets);

}  // namespace raycat
