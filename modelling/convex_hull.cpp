#include "modelling/convex_hull.hpp"

#include <cstdint>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

bool in_one_plane(const Surface& hull) {
  if (hull.number_of_vertices() < 4) {
    return true;
  }
  const Surface::Halfedge_index edge = hull.halfedge(*hull.faces().begin());
  for (const Surface::Vertex_index vertex : hull.vertices()) {
    if (!CGAL::coplanar(hull.point(hull.source(edge)), hull.point(hull.target(edge)),
                        hull.point(hull.target(hull.next(edge))), hull.point(vertex))) {
      return false;
    }
  }
  return true;
}

}  // namespace

TriangleMesh convex_hull(std::span<const glm::dvec3> points) {
  std::vector<Kernel::Point_3> corners;
  corners.reserve(points.size());
  for (const glm::dvec3& p : points) {
    corners.emplace_back(p.x, p.y, p.z);
  }
  Surface hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
  TriangleMesh mesh;
  if (in_one_plane(hull)) {
    return mesh;
  }
  for (const Surface::Vertex_index vertex : hull.vertices()) {
    const Kernel::Point_3& p = hull.point(vertex);
    mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  const auto number = [](Surface::Vertex_index vertex) {
    return static_cast<std::uint32_t>(vertex.idx());
  };
  for (const Surface::Face_index face : hull.faces()) {
    const Surface::Halfedge_index edge = hull.halfedge(face);
    mesh.triangles.emplace_back(number(hull.source(edge)), number(hull.target(edge)),
                                number(hull.target(hull.next(edge))));
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

}  // namespace raycat
