#include "geometry/joined_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/weld.hpp"

namespace raycat {

TriangleMesh placed(TriangleMesh mesh, const Affine& transform) {
  for (glm::dvec3& position : mesh.positions) {
    position = transform.point(position);
  }
  if (transform.mirrored()) {
    for (glm::uvec3& triangle : mesh.triangles) {
      triangle = {triangle.x, triangle.z, triangle.y};
    }
  }
  return mesh;
}

void append(TriangleMesh& all, const TriangleMesh& mesh, std::uint32_t first_face) {
  const auto first_vertex = static_cast<std::uint32_t>(all.positions.size());
  all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const glm::uvec3& triangle : mesh.triangles) {
    all.triangles.push_back(triangle + first_vertex);
  }
  for (const std::uint32_t face : mesh.faces) {
    all.faces.push_back(first_face + face);
  }
  all.face_count = std::max(all.face_count, first_face + mesh.face_count);
}

TriangleMesh joined(std::span<const TriangleMesh* const> meshes) {
  TriangleMesh all;
  for (const TriangleMesh* mesh : meshes) {
    append(all, *mesh, all.face_count);
  }
  return all;
}

void weld_corners(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> same = weld(mesh.positions);
  std::vector<std::uint32_t> number(same.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < same.size(); ++i) {
    if (same[i] == i) {
      mesh.positions[kept] = mesh.positions[i];
      number[i] = kept++;
    }
  }
  mesh.positions.resize(kept);
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::uvec3 welded(number[same[t.x]], number[same[t.y]], number[same[t.z]]);
    if (welded.x != welded.y && welded.y != welded.z && welded.z != welded.x) {
      mesh.triangles[triangles] = welded;
      mesh.faces[triangles++] = mesh.faces[i];
    }
  }
  mesh.triangles.resize(triangles);
  mesh.faces.resize(triangles);
}

}  // namespace raycat
