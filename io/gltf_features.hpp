#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/gltf_document.hpp"

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

/// The feature ids that a primitive of a mesh gives to its vertices, where it has those of
/// EXT_mesh_features: of the first set that is not in a texture. `vertices` are the vertices asked
/// for, of `count` that there are. Vertices without a feature share the last id. Nothing, with a
/// warning in the document, if there are ids that cannot be read.
struct FeatureIds {
  std::vector<std::uint32_t> of_vertex;
  std::uint32_t count = 0;  ///< more than every id
};
std::optional<FeatureIds> feature_ids(GltfDocument& document, std::size_t mesh,
                                      std::size_t primitive,
                                      std::span<const std::uint32_t> vertices, std::size_t count);

}  // namespace raycat
