#include "io/gltf_mesh.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "geometry/mesh.hpp"
#include "io/gltf_primitive.hpp"

namespace raycat {
namespace {

std::vector<const TriangleMesh*> triangles(const GltfMesh& mesh) {
  std::vector<const TriangleMesh*> triangles;
  for (const GltfPrimitive& primitive : mesh.primitives) {
    triangles.push_back(&primitive.mesh->triangles);
  }
  return triangles;
}

}  // namespace

TriangleMesh joined(const std::vector<const TriangleMesh*>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh* mesh : meshes) {
    const auto first_vertex = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), mesh->positions.begin(), mesh->positions.end());
    for (const glm::uvec3& triangle : mesh->triangles) {
      all.triangles.push_back(triangle + first_vertex);
    }
    for (const std::uint32_t face : mesh->faces) {
      all.faces.push_back(all.face_count + face);
    }
    all.face_count += mesh->face_count;
  }
  return all;
}

GltfMeshes::GltfMeshes(GltfDocument& document, const std::vector<GltfMaterial>& materials,
                       const FaceRule& faces, LoadBudget& budget)
    : document_(document),
      materials_(materials),
      faces_(faces),
      budget_(budget),
      meshes_(document.model.meshes.size()),
      solids_(document.model.meshes.size()) {}

const GltfMesh& GltfMeshes::mesh(std::size_t number) {
  if (!meshes_[number]) {
    meshes_[number] = read(number);
  }
  return *meshes_[number];
}

MeshShape GltfMeshes::solid(std::size_t number) {
  if (!solids_[number]) {
    const GltfMesh& from = mesh(number);
    TriangleMesh all = joined(triangles(from));
    if (from.names) {
      all.faces.clear();
      for (const TriangleMesh* primitive : triangles(from)) {
        all.faces.insert(all.faces.end(), primitive->faces.begin(), primitive->faces.end());
      }
    }
    solids_[number] = std::make_shared<const ClosedMesh>(std::move(all));
  }
  return solids_[number];
}

// Other tools may have kept the extras, but not the features that they name.
std::optional<FeatureNames> GltfMeshes::names(std::size_t number) {
  for (const auto& primitive : document_.json["meshes"][number]["primitives"]) {
    const auto extensions = primitive.find("extensions");
    if (extensions == primitive.end() || !extensions->contains("EXT_mesh_features")) {
      return std::nullopt;
    }
  }
  return feature_names(document_, number);
}

GltfMesh GltfMeshes::read(std::size_t number) {
  const auto& from = document_.model.meshes[number].primitives;
  GltfMesh mesh;
  mesh.names = names(number);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!from[i].targets.empty()) {
      document_.warnings.push_back(
          fmt::format("meshes[{}]: primitives[{}]: morph targets are ignored", number, i));
    }
    std::optional<std::size_t> material;
    if (from[i].material >= 0) {
      material = static_cast<std::size_t>(from[i].material);
    }
    const auto surface =
        read_primitive(document_, number, i, material ? &materials_[*material] : nullptr, faces_,
                       mesh.names ? &*mesh.names : nullptr, budget_);
    if (surface && !surface->triangles.triangles.empty()) {
      mesh.primitives.push_back({.mesh = surface,
                                 .material = material,
                                 .triangles = surface->triangles.triangles.size()});
    }
  }
  return mesh;
}

}  // namespace raycat
