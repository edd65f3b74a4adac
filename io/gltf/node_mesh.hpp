#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/gltf/instances.hpp"
#include "io/gltf/mesh.hpp"
#include "io/gltf/nodes.hpp"

namespace raycat {

/// The mesh of a node as the scene has it: in its pose, and where it is. Keeps references.
class GltfNodeMeshes {
 public:
  GltfNodeMeshes(GltfDocument& document, GltfMeshes& meshes, const GltfNodes& nodes,
                 LoadBudget& budget)
      : document_(document), meshes_(meshes), nodes_(nodes), budget_(budget) {}

  /// The mesh at rest. The node must have one, as for all of these.
  const GltfMesh& at_rest(std::size_t node) const { return meshes_.mesh(number(node)); }

  /// The mesh with the node's morph weights and skin; nothing if it is as at rest.
  std::optional<GltfMesh> posed(std::size_t node) const;

  /// The mesh as it is, as a solid. Throws `std::invalid_argument` as `ClosedMesh` does.
  MeshShape solid(std::size_t node) const;

  /// Where it is in the world; each of these is an object.
  std::vector<GltfInstanceGroup> places(std::size_t node) const;

  /// The triangles of all its instances, none of which is taken from the budget.
  std::uint64_t triangles(std::size_t node) const;

 private:
  std::size_t number(std::size_t node) const;

  GltfDocument& document_;
  GltfMeshes& meshes_;
  const GltfNodes& nodes_;
  LoadBudget& budget_;
};

}  // namespace raycat
