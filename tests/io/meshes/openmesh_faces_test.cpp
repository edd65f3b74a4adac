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

// Is each of the `finer` parts in one of the others?
bool lie_within(const std::vector<std::uint32_t>& finer,
                const std::vector<std::uint32_t>& coarser) {
  std::map<std::uint32_t, std::uint32_t> within;
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if (within.emplace(finer[i], coarser[i]).first->second != coarser[i]) {
      return false;
    }
  }
  return true;
}

// May an end of a border's edge lie on the inside of another? Or the border is too long to tell.
bool edges_meet_inside(const TriangleMesh& mesh, const HalfEdges& edges) {
  std::vector<std::array<glm::dvec3, 2>> border;
  for (const auto half : edges.halfedges()) {
    if (edges.is_boundary(half)) {
      const auto at = [&](HalfEdges::VertexHandle vertex) {
        return mesh.positions[static_cast<std::size_t>(vertex.idx())];
      };
      border.push_back({at(edges.from_vertex_handle(half)), at(edges.to_vertex_handle(half))});
    }
  }
  constexpr std::size_t long_border = 3000;
  if (border.size() > long_border) {
    return true;
  }
  for (const auto& [a, b] : border) {
    const double length = glm::distance(a, b);
    for (const auto& [p, end] : border) {
      constexpr double near = 1e-3;
      if (p != a && p != b && glm::distance(a, p) + glm::distance(p, b) < (1.0 + near) * length) {
        return true;
      }
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
  std::size_t whole_edges = 0;  // of those compared
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
      const bool may_meet_inside_edges = edges_meet_inside(mesh, edges);
      whole_edges += may_meet_inside_edges ? 0U : 1U;
      for (const double degrees : {5.0, 30.0, 75.0}) {
        const double crease = degrees * 0.017453292519943295;
        const auto faces =
            group_faces(mesh.positions, mesh.triangles, {}, {.crease = crease}).faces;
        // Between them are only angles that may be the crease itself, but for rounding.
        constexpr double surely = 31.0 / 32.0;
        CHECK(lie_within(regions(mesh, edges, surely * crease), faces));
        if (!may_meet_inside_edges) {
          CHECK(lie_within(faces, regions(mesh, edges, crease)));
        }
      }
      ++compared;
    }
  }
  CHECK(compared > 100);
  CHECK(whole_edges > 60);
  CHECK(not_manifold > 0);
}

}  // namespace
}  // namespace raycat
