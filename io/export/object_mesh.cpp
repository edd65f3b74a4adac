#include "io/export/object_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/joined_mesh.hpp"
#include "modelling/evaluate.hpp"

namespace raycat {
namespace {

std::uint32_t offset(SurfaceId face, SurfaceId first) {
  return static_cast<std::uint32_t>(face) - static_cast<std::uint32_t>(first);
}

ObjectMesh::Part placed(const MeshInstance& instance, SurfaceId first) {
  ObjectMesh::Part part{.mesh = *instance.mesh, .material = instance.material};
  TriangleMesh& mesh = part.mesh.triangles;
  mesh = placed(std::move(mesh), instance.transform);
  for (glm::vec3& normal : part.mesh.normals) {
    normal = glm::vec3(instance.transform.normal(glm::dvec3(normal)));
  }
  const std::uint32_t before = offset(instance.first_face, first);
  for (std::uint32_t& face : mesh.faces) {
    face += before;
  }
  mesh.face_count += before;
  return part;
}

// The triangles sorted by material, each with the vertices it uses.
void add_evaluated(const SolidObject& object, const EvaluatedMesh& evaluated, ObjectMesh& out) {
  constexpr std::uint32_t unused = ~std::uint32_t{0};
  const auto leaves = object.solid.tree().leaves();
  std::map<MaterialId, std::size_t> part_of;
  std::vector<std::vector<std::uint32_t>> vertex_of;  // by part
  for (std::size_t i = 0; i < evaluated.mesh.triangles.size(); ++i) {
    const EvaluatedMesh::Origin& origin = evaluated.origins[evaluated.mesh.faces[i]];
    const MaterialId material = object.materials[origin.leaf];
    const auto [found, is_new] = part_of.try_emplace(material, out.parts.size());
    if (is_new) {
      out.parts.push_back({.mesh = {}, .material = material});
      vertex_of.emplace_back(evaluated.mesh.positions.size(), unused);
    }
    TriangleMesh& mesh = out.parts[found->second].mesh.triangles;
    glm::uvec3 triangle;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = evaluated.mesh.triangles[i][k];
      std::uint32_t& vertex = vertex_of[found->second][from];
      if (vertex == unused) {
        vertex = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(evaluated.mesh.positions[from]);
      }
      triangle[k] = vertex;
    }
    const std::uint32_t face = offset(leaves[origin.leaf].first_face, out.first_face) + origin.face;
    mesh.triangles.push_back(triangle);
    mesh.faces.push_back(face);
    mesh.face_count = std::max(mesh.face_count, face + 1);
  }
}

}  // namespace

std::vector<ObjectMesh> object_meshes(const Scene& scene, double chord_error) {
  std::vector<ObjectMesh> out(scene.surfaces.objects());
  for (std::uint32_t face = 0; face < scene.surfaces.faces(); ++face) {
    ObjectMesh& object = out[static_cast<std::size_t>(scene.surfaces.object(SurfaceId{face}))];
    if (face == 0 ||
        scene.surfaces.object(SurfaceId{face - 1}) != scene.surfaces.object(SurfaceId{face})) {
      object.first_face = SurfaceId{face};
    }
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].object = static_cast<ObjectId>(i);
  }
  const auto object_of = [&](SurfaceId face) -> ObjectMesh& {
    return out[static_cast<std::size_t>(scene.surfaces.object(face))];
  };
  for (const MeshInstance& instance : scene.meshes) {
    ObjectMesh& object = object_of(instance.first_face);
    object.parts.push_back(placed(instance, object.first_face));
  }
  for (const SolidObject& solid : scene.solids) {
    ObjectMesh& object = object_of(solid.solid.tree().leaves().front().first_face);
    if (!solid.solid.bounds().empty() && !solid.solid.bounds().finite()) {
      object.endless = &solid;
      continue;
    }
    try {
      add_evaluated(solid, evaluate(solid.solid.tree(), {.chord_error = chord_error}), object);
    } catch (const std::logic_error& error) {
      throw std::invalid_argument(
          fmt::format("{}: {}", scene.surfaces.name(object.object), error.what()));
    }
  }
  return out;
}

std::vector<std::string> without_parts(const SurfaceTable& surfaces,
                                       std::span<const ObjectMesh> objects) {
  std::vector<std::string> out;
  for (const ObjectMesh& object : objects) {
    if (object.parts.empty()) {
      out.push_back(fmt::format("{}: {}", surfaces.name(object.object),
                                object.endless != nullptr
                                    ? "is left out, since a half-space leaves it without end"
                                    : "has no surface and is left out"));
    }
  }
  return out;
}

TriangleMesh welded_mesh(const ObjectMesh& object) {
  TriangleMesh all;
  for (const ObjectMesh::Part& part : object.parts) {
    append(all, part.mesh.triangles, 0);
  }
  weld_corners(all);
  return all;
}

}  // namespace raycat
