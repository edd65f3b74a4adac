#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "io/gltf/document.hpp"
#include "io/gltf/features.hpp"
#include "io/gltf/material.hpp"
#include "io/scene/scene_file.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// The triangles of a glTF primitive.
struct GltfPrimitive {
  std::size_t number = 0;             ///< in its mesh
  std::shared_ptr<SurfaceMesh> mesh;  ///< that changes no more once its faces are found
  std::optional<std::size_t> material;
  std::uint64_t triangles = 0;  ///< as the file has them

  /// Which of the file's vertices each of the mesh's is, ascending; only of a primitive that has
  /// morph targets or joints.
  std::vector<std::uint32_t> vertices;

  bool has_faces = false;  ///< told by the file? Else they are to be found by angle
};

/// Reads the triangles of one primitive of a mesh, whose material is `material` or null, with the
/// texture coordinates that it needs. Its faces are those that the file tells: its features, as
/// `names` has them if it is not null, or else polygons or an outline. Without these it has none
/// yet. Takes what it holds from the
/// budget. The primitive must be of triangles. Nothing if it has no positions; then `document` has
/// a warning more. Triangles with a corner that is not finite are dropped with a warning. Throws
/// `LoadError`.
std::optional<GltfPrimitive> read_primitive(GltfDocument& document, std::size_t mesh,
                                            std::size_t primitive, const GltfMaterial* material,
                                            const FeatureNames* names, GltfTextures& textures,
                                            LoadBudget& budget, int threads);

}  // namespace raycat
