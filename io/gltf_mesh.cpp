#include "io/gltf_mesh.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "geometry/mesh.hpp"
#include "io/gltf_primitive.hpp"
#include "io/scene_file.hpp"

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
    if (from[i].mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      throw LoadError(
          document_.file, fmt::format("meshes[{}]", number),
          fmt::format("primitives[{}]: mode {} is not one of glTF 2.0", i, from[i].mode));
    }
    if (from[i].mode < TINYGLTF_MODE_TRIANGLES) {
      ++undrawn_;
      continue;
    }
    const GltfMaterial* material =
        from[i].material < 0 ? nullptr : &materials_[static_cast<std::size_t>(from[i].material)];
    auto primitive = read_primitive(document_, number, i, material, faces_,
                                    mesh.names ? &*mesh.names : nullptr, budget_);
    if (primitive && primitive->triangles > 0) {
      mesh.primitives.push_back(*std::move(primitive));
    }
  }
  return mesh;
}

}  // namespace raycat
