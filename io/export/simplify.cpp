#include "io/export/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/joined_mesh.hpp"
#include "geometry/weld.hpp"

namespace raycat {
namespace {

struct DoublePrecision : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<DoublePrecision>;
using Vertex = HalfEdges::VertexHandle;

// An object's parts in one, so that what is closed between them stays so.
struct Whole {
  TriangleMesh mesh;                     // every part's faces after those of the parts before it
  std::vector<std::uint32_t> same;       // the first vertex at the place of each
  std::vector<std::uint32_t> triangles;  // those that are surface, by the number in the half edges

  explicit Whole(const ObjectMesh& object) {
    for (const ObjectMesh::Part& part : object.parts) {
      append(mesh, part.mesh.triangles, mesh.face_count);
    }
    same = weld(mesh.positions);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3 t = welded(i);
      if (t.x != t.y && t.y != t.z && t.z != t.x) {
        triangles.push_back(i);
      }
    }
  }

  glm::uvec3 welded(std::uint32_t triangle) const {
    const glm::uvec3& t = mesh.triangles[triangle];
    return {same[t.x], same[t.y], same[t.z]};
  }
};

// None if OpenMesh drops a triangle, which it does where the mesh is not manifold.
std::optional<HalfEdges> half_edges(const Whole& whole) {
  const Bounds box = bounds(whole.mesh);
  const glm::dvec3 centre = box.center();
  const double half_diagonal = glm::length(box.half_size());
  HalfEdges out;
  for (const glm::dvec3& position : whole.mesh.positions) {
    // Of a size that no constant of OpenMesh's is too large or too small for.
    const glm::dvec3 p = (position - centre) / half_diagonal;
    out.add_vertex({p.x, p.y, p.z});
  }
  const auto vertex = [](std::uint32_t i) { return Vertex(static_cast<int>(i)); };
  for (const std::uint32_t triangle : whole.triangles) {
    const glm::uvec3 t = whole.welded(triangle);
    if (!out.add_face(vertex(t.x), vertex(t.y), vertex(t.z)).is_valid()) {
      return std::nullopt;
    }
  }
  return out;
}

// The vertices at a place may differ in what else they hold: which is a face's there? False if that
// depends on the triangle.
using VertexOfFace = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;
bool find_vertices(const Whole& whole, VertexOfFace& out) {
  for (const std::uint32_t triangle : whole.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = whole.mesh.triangles[triangle][k];
      const auto [at, is_new] =
          out.try_emplace({whole.mesh.faces[triangle], whole.same[vertex]}, vertex);
      if (at->second != vertex) {
        return false;
      }
    }
  }
  return true;
}

bool on_border(const HalfEdges& edges, Vertex vertex, const Whole& whole) {
  if (edges.is_boundary(vertex)) {
    return true;
  }
  std::optional<std::uint32_t> first;
  for (const auto triangle : edges.vf_range(vertex)) {
    const std::uint32_t face =
        whole.mesh.faces[whole.triangles[static_cast<std::size_t>(triangle.idx())]];
    if (first.value_or(face) != face) {
      return true;
    }
    first = face;
  }
  return false;
}

void decimate(HalfEdges& edges, const Whole& whole, double error) {
  using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdges>;
  Decimater decimater(edges);
  OpenMesh::Decimater::ModQuadricT<HalfEdges>::Handle quadric;
  OpenMesh::Decimater::ModHausdorffT<HalfEdges>::Handle distance;
  OpenMesh::Decimater::ModNormalFlippingT<HalfEdges>::Handle flipping;
  decimater.add(quadric);
  decimater.add(distance);
  decimater.add(flipping);
  decimater.module(quadric).set_max_err(error * error, false);
  decimater.module(distance).set_tolerance(error);
  for (const auto vertex : edges.vertices()) {
    edges.status(vertex).set_locked(on_border(edges, vertex, whole));
  }
  edges.update_face_normals();
  decimater.initialize();
  decimater.decimate();
}

template <typename Value>
void keep(const std::vector<std::uint32_t>& kept, std::vector<Value>& values) {
  if (!values.empty()) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      values[i] = values[kept[i]];
    }
    values.resize(kept.size());
  }
}

// Leaves the triangles that are given, by their numbers, and the vertices that they have.
void keep(const std::vector<std::uint32_t>& triangles, SurfaceMesh& mesh) {
  keep(triangles, mesh.triangles.triangles);
  keep(triangles, mesh.triangles.faces);
  constexpr std::uint32_t unused = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(mesh.triangles.positions.size(), unused);
  for (const glm::uvec3& t : mesh.triangles.triangles) {
    number[t.x] = number[t.y] = number[t.z] = 0;
  }
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < number.size(); ++i) {
    if (number[i] != unused) {
      number[i] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(i);
    }
  }
  for (glm::uvec3& t : mesh.triangles.triangles) {
    t = {number[t.x], number[t.y], number[t.z]};
  }
  keep(vertices, mesh.triangles.positions);
  keep(vertices, mesh.normals);
  keep(vertices, mesh.colours);
  for (std::vector<glm::vec2>& set : mesh.texture_coordinates) {
    keep(vertices, set);
  }
}

// Takes what was deleted out of the parts.
void take_over(const HalfEdges& edges, const Whole& whole, const VertexOfFace& vertex_of,
               ObjectMesh& object) {
  auto triangle = edges.faces_sbegin();
  std::uint32_t first_triangle = 0;
  std::uint32_t first_vertex = 0;
  for (ObjectMesh::Part& part : object.parts) {
    TriangleMesh& mesh = part.mesh.triangles;
    const auto end = first_triangle + static_cast<std::uint32_t>(mesh.triangles.size());
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<std::uint32_t> kept;
    for (; triangle != edges.faces_end(); ++triangle) {
      const std::uint32_t number = whole.triangles[static_cast<std::size_t>(triangle->idx())];
      if (number >= end) {
        break;
      }
      kept.push_back(number - first_triangle);
      int corner = 0;
      for (const auto vertex : edges.fv_range(*triangle)) {
        mesh.triangles[kept.back()][corner++] =
            vertex_of.at({whole.mesh.faces[number], static_cast<std::uint32_t>(vertex.idx())}) -
            first_vertex;
      }
    }
    keep(kept, part.mesh);
    first_triangle = end;
    first_vertex += vertices;
  }
}

bool simplify(ObjectMesh& object, double error) {
  const auto has_own_rules = [](const ObjectMesh::Part& part) {
    return part.mesh.features != nullptr || !part.mesh.twins.empty();
  };
  if (std::ranges::any_of(object.parts, has_own_rules)) {
    return false;
  }
  const Whole whole(object);
  VertexOfFace vertex_of;
  std::optional<HalfEdges> edges = half_edges(whole);
  if (!edges || !find_vertices(whole, vertex_of)) {
    return false;
  }
  decimate(*edges, whole, error);
  take_over(*edges, whole, vertex_of, object);
  return true;
}

}  // namespace

std::vector<std::string> simplify(const SurfaceTable& surfaces, std::vector<ObjectMesh>& objects,
                                  double error) {
  omerr().disable();
  std::vector<std::string> out;
  for (ObjectMesh& object : objects) {
    if (!object.parts.empty() && !simplify(object, error)) {
      out.push_back(fmt::format(
          "{}: is not simplified: its triangles do not make up a manifold, or an image tells its "
          "faces, or a face has seams",
          surfaces.name(object.object)));
    }
  }
  return out;
}

}  // namespace raycat
