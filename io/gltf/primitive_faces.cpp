#include "io/gltf/primitive_faces.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "geometry/coincident_twins.hpp"
#include "geometry/disjoint_sets.hpp"
#include "geometry/mesh_faces.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

// What primitives must have in common to be one surface: a material, which attributes they have,
// and whether a pose moves their vertices.
using Kind = std::pair<std::optional<std::size_t>, std::vector<bool>>;

Kind kind(const GltfPrimitive& primitive) {
  const SurfaceMesh& mesh = *primitive.mesh;
  std::vector<bool> has{!mesh.normals.empty(), !mesh.colours.empty(), !primitive.vertices.empty()};
  for (const auto& coordinates : mesh.texture_coordinates) {
    has.push_back(!coordinates.empty());
  }
  return {primitive.material, std::move(has)};
}

void find_faces_alone(SurfaceMesh& mesh, const LoadOptions& options) {
  TriangleMesh& triangles = mesh.triangles;
  MeshFaces found = group_faces(triangles.positions, triangles.triangles, mesh.normals,
                                options.faces, options.threads);
  triangles.faces = std::move(found.faces);
  triangles.face_count = triangles.faces.empty() ? 0 : std::ranges::max(triangles.faces) + 1;
  mesh.twins = std::move(found.twins);
}

// The faces of meshes as if they were one, counted through all.
void find_faces_together(const std::vector<SurfaceMesh*>& meshes, const LoadOptions& options) {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;
  std::vector<glm::vec3> normals;
  for (const SurfaceMesh* mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    const TriangleMesh& from = mesh->triangles;
    positions.insert(positions.end(), from.positions.begin(), from.positions.end());
    normals.insert(normals.end(), mesh->normals.begin(), mesh->normals.end());
    for (const glm::uvec3& triangle : from.triangles) {
      triangles.push_back(triangle + first);
    }
  }
  const MeshFaces found =
      group_faces(positions, triangles, normals, options.faces, options.threads);
  auto next = found.faces.begin();
  for (SurfaceMesh* mesh : meshes) {
    TriangleMesh& of = mesh->triangles;
    const auto end = next + static_cast<std::ptrdiff_t>(of.triangles.size());
    of.faces.assign(next, end);
    next = end;
    if (!found.twins.empty()) {  // which may be of different meshes
      mesh->twins = coincident_twins(of.positions, of.triangles, options.threads);
    }
  }
}

std::uint32_t count_of(const std::vector<SurfaceMesh*>& meshes) {
  std::uint32_t count = 0;
  for (const SurfaceMesh* mesh : meshes) {
    for (const std::uint32_t face : mesh->triangles.faces) {
      count = std::max(count, face + 1);
    }
  }
  return count;
}

// Which of the meshes hang together by faces that they share, by the first of them.
std::vector<std::uint32_t> sharing_faces(const std::vector<SurfaceMesh*>& meshes) {
  DisjointSets sharing(meshes.size());
  std::vector<std::uint32_t> mesh_of_face(count_of(meshes), none);
  for (std::uint32_t i = 0; i < meshes.size(); ++i) {
    for (const std::uint32_t face : meshes[i]->triangles.faces) {
      std::uint32_t& mesh = mesh_of_face[face];
      mesh = mesh == none ? i : mesh;
      sharing.join(i, mesh);
    }
  }
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < meshes.size(); ++i) {
    first.push_back(sharing.first(i));
  }
  return first;
}

// Counts the faces of the meshes of each set from 0, in their order.
void count_anew(const std::vector<SurfaceMesh*>& meshes, const std::vector<std::uint32_t>& sets) {
  std::vector<std::uint32_t> number(count_of(meshes), none);
  std::vector<std::uint32_t> counts(meshes.size(), 0);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    std::uint32_t& count = counts[sets[i]];
    for (std::uint32_t& face : meshes[i]->triangles.faces) {
      number[face] = number[face] == none ? count++ : number[face];
      face = number[face];
    }
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes[i]->triangles.face_count = counts[sets[i]];
  }
}

}  // namespace

GltfSurfaces find_faces(std::vector<GltfPrimitive>& primitives, const LoadOptions& options) {
  std::vector<std::size_t> first_of(primitives.size());  // of the surface of each
  std::map<Kind, std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    first_of[i] = i;
    if (!primitives[i].has_faces && options.join_primitives) {
      alike[kind(primitives[i])].push_back(i);
    } else if (!primitives[i].has_faces) {
      find_faces_alone(*primitives[i].mesh, options);
    }
  }
  for (const auto& [of_kind, numbers] : alike) {
    if (numbers.size() == 1) {
      find_faces_alone(*primitives[numbers.front()].mesh, options);
      continue;
    }
    std::vector<SurfaceMesh*> meshes;
    for (const std::size_t number : numbers) {
      meshes.push_back(primitives[number].mesh.get());
    }
    find_faces_together(meshes, options);
    const std::vector<std::uint32_t> sets = sharing_faces(meshes);
    count_anew(meshes, sets);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      first_of[numbers[k]] = numbers[sets[k]];
    }
  }
  GltfSurfaces out;
  out.of.resize(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (first_of[i] == i) {
      out.of[i] = out.surfaces.size();
      out.surfaces.push_back(
          {.first_primitive = i, .face_count = primitives[i].mesh->triangles.face_count});
    } else {
      out.of[i] = out.of[first_of[i]];
    }
  }
  return out;
}

}  // namespace raycat
