#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/shape.hpp"
#include "io/gltf/document.hpp"
#include "io/gltf/features.hpp"
#include "io/gltf/material.hpp"
#include "io/gltf/primitive.hpp"
#include "io/gltf/primitive_faces.hpp"
#include "io/scene/scene_file.hpp"
#include "tracer/scene.hpp"

namespace raycat {

struct GltfMesh {
  std::vector<GltfPrimitive> primitives;   ///< those that are made of triangles
  std::optional<FeatureNames> names;       ///< by which all count their faces, if there are
  GltfSurfaces surfaces;                   ///< what the primitives are if there are no names
  std::vector<std::uint32_t> first_faces;  ///< of each primitive, among those of the mesh
};

/// The meshes of a document, each read when it is first asked for and shared by its instances.
class GltfMeshes {
 public:
  /// Keeps references to all. `materials` say which texture coordinates to read.
  GltfMeshes(GltfDocument& document, const std::vector<GltfMaterial>& materials,
             const LoadOptions& options, GltfTextures& textures, LoadBudget& budget);

  /// Throws `LoadError`.
  const GltfMesh& mesh(std::size_t number);

  /// Primitives of points and lines that were met, which have no surface and are not drawn.
  std::size_t undrawn() const noexcept { return undrawn_; }

  /// Accessors of positions that were met whose `min` or `max` is not that of the data.
  const std::vector<std::size_t>& misstated() const noexcept { return misstated_; }

  /// All primitives as one solid with the faces of all. Throws `std::invalid_argument` as
  /// `ClosedMesh` does.
  MeshShape solid(std::size_t number);

 private:
  void check_bounds(std::size_t accessor);
  GltfMesh read(std::size_t number);
  std::optional<FeatureNames> names(std::size_t number);

  GltfDocument& document_;
  const std::vector<GltfMaterial>& materials_;
  const LoadOptions& options_;
  GltfTextures& textures_;
  LoadBudget& budget_;
  std::vector<std::optional<GltfMesh>> meshes_;
  std::vector<MeshShape> solids_;
  std::size_t undrawn_ = 0;
  std::vector<bool> checked_;  // which accessors' bounds have been
  std::vector<std::size_t> misstated_;
};

/// All primitives of a mesh as one solid. Throws `std::invalid_argument` as `ClosedMesh` does.
MeshShape closed(const GltfMesh& mesh);

}  // namespace raycat
