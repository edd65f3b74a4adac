#include "io/gltf/node_mesh.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/gltf/deformation.hpp"

namespace raycat {

std::size_t GltfNodeMeshes::number(std::size_t node) const {
  return static_cast<std::size_t>(document_.model.nodes[node].mesh);
}

std::optional<GltfMesh> GltfNodeMeshes::posed(std::size_t node) const {
  const auto& from = document_.model.nodes[node];
  const GltfMesh& rest = at_rest(node);
  const auto& weights =
      from.weights.empty() ? document_.model.meshes[number(node)].weights : from.weights;
  std::vector<glm::dmat4> joints;
  if (from.skin >= 0) {
    joints = joint_matrices(document_, static_cast<std::size_t>(from.skin), nodes_);
  }
  const bool morphed = std::ranges::any_of(weights, [](double weight) { return weight != 0.0; });
  if (!morphed && joints.empty()) {
    return std::nullopt;
  }
  GltfMesh mesh = rest;
  for (GltfPrimitive& primitive : mesh.primitives) {
    if (!primitive.vertices.empty()) {
      constexpr std::uint64_t bytes_a_vertex = 256;
      budget_.take_memory(document_.file, document_.node_place(node), primitive.vertices.size(),
                          bytes_a_vertex);
      primitive.mesh = deformed(document_, number(node), primitive, weights, joints);
    }
  }
  return mesh;
}

MeshShape GltfNodeMeshes::solid(std::size_t node) const {
  const std::optional<GltfMesh> moved = posed(node);
  return moved ? closed(*moved) : meshes_.solid(number(node));
}

std::vector<GltfInstanceGroup> GltfNodeMeshes::places(std::size_t node) const {
  auto groups = instance_groups(document_, node, budget_);
  if (document_.model.nodes[node].skin >= 0) {
    if (groups) {
      document_.warnings.push_back(fmt::format(
          "{}: its instances are left out, since its mesh has a skin", document_.node_place(node)));
    }
    // A skin's joints say where its mesh is, not its node.
    return {{.label = "", .transforms = {glm::dmat4(1.0)}}};
  }
  if (!groups) {
    return {{.label = "", .transforms = {nodes_.world[node]}}};
  }
  for (GltfInstanceGroup& group : *groups) {
    for (glm::dmat4& transform : group.transforms) {
      transform = nodes_.world[node] * transform;
    }
  }
  return *std::move(groups);
}

std::uint64_t GltfNodeMeshes::triangles(std::size_t node) const {
  const auto groups = instance_groups(document_, node, budget_);
  std::uint64_t places = groups ? 0 : 1;
  for (const GltfInstanceGroup& group : groups.value_or(std::vector<GltfInstanceGroup>())) {
    places += group.transforms.size();
  }
  std::uint64_t triangles = 0;
  for (const GltfPrimitive& primitive : at_rest(node).primitives) {
    triangles += places * primitive.triangles;
  }
  return triangles;
}

}  // namespace raycat
