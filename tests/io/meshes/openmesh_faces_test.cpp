// The faces of real meshes, found a second time along the half edges of OpenMesh.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "geometry/mesh_faces.hpp"
#include "geometry/weld.hpp"
#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"
#include "tests/io/gltf/files.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

struct DoublePrecision : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<DoublePrecision>;

glm::dvec3 unit_normal(const TriangleMesh& mesh, std::size_t triangle) {
  const glm::uvec3 t = mesh.triangles[triangle];
  return glm::normalize(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                   mesh.positions[t.z] - mesh.positions[t.x]));
}

// The mesh as half edges, its equal positions joined; empty if OpenMesh drops a triangle, which it
// does where the mesh is not manifold.
HalfEdges half_edges(const TriangleMesh& mesh) {
  HalfEdges out;
  std::vector<HalfEdges::VertexHandle> vertices;
  for (const glm::dvec3& p : mesh.positions) {
    vertices.push_back(out.add_vertex({p.x, p.y, p.z}));
  }
  const std::vector<std::uint32_t> welded = weld(mesh.positions);
  for (const glm::uvec3& t : mesh.triangles) {
    const auto face =
        out.add_face(vertices[welded[t.x]], vertices[welded[t.y]], vertices[welded[t.z]]);
    if (!face.is_valid()) {
      return {};
    }
  }
  return out;
}

// Which triangles hang together over edges of less than the crease, numbered by their first.
std::vector<std::uint32_t> regions(const TriangleMesh& mesh, const HalfEdges& edges,
                                   double crease) {
  std::vector<std::uint32_t> region(mesh.triangles.size(), 0xffffffffu);
  std::uint32_t count = 0;
  for (std::size_t first = 0; first < region.size(); ++first) {
    if (region[first] != 0xffffffffu) {
      continue;
    }
    std::vector<std::size_t> pending{first};
    region[first] = count;
    while (!pending.empty()) {
      const std::size_t triangle = pending.back();
      pending.pop_back();
      for (const auto next : edges.ff_range(HalfEdges::FaceHandle(static_cast<int>(triangle)))) {
        const auto other = static_cast<std::size_t>(next.idx());
        const double angle = std::acos(
            glm::clamp(glm::dot(unit_normal(mesh, triangle), unit_normal(mesh, other)), -1.0, 1.0));
        if (region[other] == 0xffffffffu && angle < crease) {
          region[other] = count;
          pending.push_back(other);
        }
      }
    }
    ++count;
  }
  return region;
}

bool has_degenerate_triangle(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!std::isfinite(unit_normal(mesh, i).x)) {
      return true;
    }
  }
  return false;
}

TEST_CASE("faces are what OpenMesh's half edges join, where a mesh is manifold", "[io][gltf]") {
  const auto folder = corpus() / "gltf";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  std::size_t compared = 0;
  std::size_t not_manifold = 0;
  for (const auto& path : gltf_files(folder)) {
    SceneFile file;
    try {
      file = load_scene(path);
    } catch (const LoadError&) {
      continue;  // as another test says, for a good reason
    }
    for (const MeshInstance& instance : file.scene.meshes) {
      const TriangleMesh& mesh = instance.mesh->triangles;
      constexpr std::size_t large = 50'000;
      if (mesh.triangles.size() > large || has_degenerate_triangle(mesh)) {
        continue;
      }
      const HalfEdges edges = half_edges(mesh);
      if (edges.n_faces() != mesh.triangles.size()) {
        ++not_manifold;
        continue;
      }
      INFO(path);
      for (const double degrees : {5.0, 30.0, 75.0}) {
        const double crease = degrees * 0.017453292519943295;
        CHECK(group_faces(mesh.positions, mesh.triangles, {}, {.crease = crease}).faces ==
              regions(mesh, edges, crease));
      }
      ++compared;
    }
  }
  CHECK(compared > 100);
  CHECK(not_manifold > 0);
}

}  // namespace
}  // namespace raycat
