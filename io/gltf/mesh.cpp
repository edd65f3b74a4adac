#include "io/gltf/mesh.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "geometry/joined_mesh.hpp"
#include "geometry/mesh.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"
#include "io/gltf/primitive.hpp"
#include "io/scene/scene_file.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

// Those of a mesh with names are counted by these alone.
std::vector<std::uint32_t> first_faces(const GltfMesh& mesh) {
  std::vector<std::uint32_t> of_surface;
  std::uint32_t first = 0;
  for (const GltfSurface& surface : mesh.surfaces.surfaces) {
    of_surface.push_back(mesh.names ? 0 : first);
    first += surface.face_count;
  }
  std::vector<std::uint32_t> out;
  for (const std::size_t surface : mesh.surfaces.of) {
    out.push_back(of_surface[surface]);
  }
  return out;
}

}  // namespace

MeshShape closed(const GltfMesh& mesh) {
  TriangleMesh all;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    append(all, mesh.primitives[i].mesh->triangles, mesh.first_faces[i]);
  }
  return std::make_shared<const ClosedMesh>(std::move(all));
}

GltfMeshes::GltfMeshes(GltfDocument& document, const std::vector<GltfMaterial>& materials,
                       const LoadOptions& options, GltfTextures& textures, LoadBudget& budget)
    : document_(document),
      materials_(materials),
      options_(options),
      textures_(textures),
      budget_(budget),
      meshes_(document.model.meshes.size()),
      solids_(document.model.meshes.size()),
      checked_(document.model.accessors.size()) {}

const GltfMesh& GltfMeshes::mesh(std::size_t number) {
  if (!meshes_[number]) {
    meshes_[number] = read(number);
  }
  return *meshes_[number];
}

MeshShape GltfMeshes::solid(std::size_t number) {
  if (!solids_[number]) {
    solids_[number] = closed(mesh(number));
  }
  return solids_[number];
}

// Exporters often get these wrong, by more than rounding. Of normalized integers they are told
// before they are mapped, and not compared.
void GltfMeshes::check_bounds(std::size_t accessor) {
  const auto& of = document_.model.accessors[accessor];
  if (checked_[accessor] || of.normalized || of.minValues.size() != 3 || of.maxValues.size() != 3) {
    return;
  }
  checked_[accessor] = true;
  const GltfAccessor values(document_, accessor);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  std::mutex taking;
  parallel_parts(values.size(), options_.threads, [&](std::size_t begin, std::size_t end, int) {
    glm::dvec3 part_low(std::numeric_limits<double>::infinity());
    glm::dvec3 part_high = -part_low;
    for (std::size_t i = begin; i < end; ++i) {
      const glm::dvec3 value(values[i]);
      part_low = glm::min(part_low, value);
      part_high = glm::max(part_high, value);
    }
    const std::lock_guard lock(taking);
    low = glm::min(low, part_low);
    high = glm::max(high, part_high);
  });
  const glm::dvec3 told_low(of.minValues[0], of.minValues[1], of.minValues[2]);
  const glm::dvec3 told_high(of.maxValues[0], of.maxValues[1], of.maxValues[2]);
  constexpr double rounding = 1e-5;
  const double error = rounding * glm::length(high - low);
  if (glm::any(glm::greaterThan(glm::abs(low - told_low), glm::dvec3(error))) ||
      glm::any(glm::greaterThan(glm::abs(high - told_high), glm::dvec3(error)))) {
    misstated_.push_back(accessor);
  }
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
    auto primitive =
        read_primitive(document_, number, i, material, mesh.names ? &*mesh.names : nullptr,
                       textures_, budget_, options_.threads);
    if (const auto positions = from[i].attributes.find("POSITION");
        positions != from[i].attributes.end()) {
      check_bounds(static_cast<std::size_t>(positions->second));
    }
    if (primitive && primitive->triangles > 0) {
      mesh.primitives.push_back(*std::move(primitive));
    }
  }
  const SpentTime grouping(budget_.spent().faces);
  mesh.surfaces = find_faces(mesh.primitives, options_);
  mesh.first_faces = first_faces(mesh);
  return mesh;
}

}  // namespace raycat
