#include "geometry/joined_mesh.hpp"

#include <algorithm>

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

}  // namespace raycat
