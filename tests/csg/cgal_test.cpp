// Set operations of meshes, evaluated by rays and by CGAL's exact corefinement.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "csg/solid.hpp"
#include "geometry/mesh.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

// A ball of 8 * rings triangles or so, dented at random, so that it is closed but not convex.
TriangleMesh dented_ball(std::mt19937& random, const glm::dvec3& centre) {
  constexpr std::uint32_t around = 10;
  constexpr std::uint32_t rings = 6;
  TriangleMesh mesh;
  const auto add = [&](double polar, double turn) {
    const double radius = uniform(random, 0.6, 1.0);
    mesh.positions.push_back(centre + radius * glm::dvec3(std::sin(polar) * std::cos(turn),
                                                          std::sin(polar) * std::sin(turn),
                                                          std::cos(polar)));
  };
  add(0.0, 0.0);
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    for (std::uint32_t k = 0; k < around; ++k) {
      add(3.141592653589793 * ring / (rings + 1), 6.283185307179586 * k / around);
    }
  }
  add(3.141592653589793, 0.0);
  const auto at = [&](std::uint32_t ring, std::uint32_t k) {
    return 1 + (ring - 1) * around + k % around;
  };
  const std::uint32_t south = 1 + rings * around;
  for (std::uint32_t k = 0; k < around; ++k) {
    mesh.triangles.emplace_back(0, at(1, k), at(1, k + 1));
    mesh.triangles.emplace_back(south, at(rings, k + 1), at(rings, k));
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
      mesh.triangles.emplace_back(at(ring, k), at(ring + 1, k), at(ring + 1, k + 1));
      mesh.triangles.emplace_back(at(ring, k), at(ring + 1, k + 1), at(ring, k + 1));
    }
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

CgalMesh to_cgal(const TriangleMesh& mesh) {
  CgalMesh out;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (const glm::dvec3& p : mesh.positions) {
    vertices.push_back(out.add_vertex(Kernel::Point_3(p.x, p.y, p.z)));
  }
  for (const glm::uvec3& t : mesh.triangles) {
    out.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);
  }
  return out;
}

TriangleMesh from_cgal(const CgalMesh& mesh) {
  TriangleMesh out;
  std::map<CgalMesh::Vertex_index, std::uint32_t> index;
  for (const auto vertex : mesh.vertices()) {
    index[vertex] = static_cast<std::uint32_t>(out.positions.size());
    const Kernel::Point_3& p = mesh.point(vertex);
    out.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : mesh.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      corners.push_back(index.at(vertex));
    }
    out.triangles.emplace_back(corners.at(0), corners.at(1), corners.at(2));
  }
  out.faces.assign(out.triangles.size(), 0);
  out.face_count = 1;
  return out;
}

std::shared_ptr<const ClosedMesh> evaluated(Operation operation, const TriangleMesh& a,
                                            const TriangleMesh& b) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  CgalMesh first = to_cgal(a);
  CgalMesh second = to_cgal(b);
  CgalMesh result;
  const bool done = operation == Operation::set_union
                        ? pmp::corefine_and_compute_union(first, second, result)
                    : operation == Operation::intersection
                        ? pmp::corefine_and_compute_intersection(first, second, result)
                        : pmp::corefine_and_compute_difference(first, second, result);
  REQUIRE(done);
  return std::make_shared<const ClosedMesh>(from_cgal(result));
}

TEST_CASE("set operations of meshes agree with CGAL's", "[csg][cgal]") {
  const Operation operation =
      GENERATE(Operation::set_union, Operation::intersection, Operation::difference);
  int lines = 0;
  int boundaries = 0;
  int different = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const TriangleMesh a = dented_ball(random, glm::dvec3(0.0));
    const TriangleMesh b = dented_ball(random, {uniform(random, 0.3, 0.8), 0.2, 0.1});
    const auto expected = evaluated(operation, a, b);
    CsgTree tree;
    const std::array operands{
        tree.add({.shape = PlacedShape(std::make_shared<const ClosedMesh>(a))}),
        tree.add({.shape = PlacedShape(std::make_shared<const ClosedMesh>(b)),
                  .first_face = SurfaceId{1}})};
    tree.add(operation, operands);
    const Solid solid(std::move(tree));

    Solid::Scratch scratch;
    Crossings crossings;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 from(uniform(random, -3, 3), uniform(random, -3, 3), 4);
      const glm::dvec3 to(uniform(random, -1, 1), uniform(random, -1, 1), 0);
      const Ray ray{.origin = from, .direction = glm::normalize(to - from)};
      solid.cross(ray, scratch);
      crossings.clear();
      expected->cross(ray, crossings);
      ++lines;
      boundaries += static_cast<int>(crossings.size());
      bool same = scratch.boundaries.size() == crossings.size();
      for (std::size_t k = 0; same && k < crossings.size(); ++k) {
        same = std::abs(scratch.boundaries[k].t - crossings[k].t) < 1e-6 &&
               scratch.boundaries[k].entering == crossings[k].entering;
      }
      different += same ? 0 : 1;
    }
  }
  CHECK(boundaries > lines / 2);
  CHECK(different == 0);
}

}  // namespace
}  // namespace raycat
