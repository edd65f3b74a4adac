#include "modelling/convex_hull.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "geometry/disjoint_sets.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;

Vertex apex(const Surface& hull, Halfedge edge) { return hull.target(hull.next(edge)); }

bool in_plane_of(const Surface& hull, Halfedge edge, Vertex vertex) {
  return CGAL::coplanar(hull.point(hull.source(edge)), hull.point(hull.target(edge)),
                        hull.point(apex(hull, edge)), hull.point(vertex));
}

bool in_one_plane(const Surface& hull) {
  if (hull.number_of_vertices() < 4) {
    return true;
  }
  const Halfedge edge = hull.halfedge(*hull.faces().begin());
  return std::ranges::all_of(hull.vertices(),
                             [&](Vertex vertex) { return in_plane_of(hull, edge, vertex); });
}

// The facets of a hull, which CGAL cuts into triangles by the order of addresses, with corners
// where it happened to meet points on them. Each is cut anew here, so that equal points have
// equal hulls.
class Facets {
 public:
  explicit Facets(const Surface& hull)
      : hull_(hull), facets_(hull.number_of_faces()), seen_(hull.number_of_faces(), false) {
    for (const Surface::Edge_index edge : hull.edges()) {
      const Halfedge side = hull.halfedge(edge);
      const Halfedge other = hull.opposite(side);
      if (in_plane_of(hull, side, apex(hull, other))) {
        facets_.join(hull.face(side).idx(), hull.face(other).idx());
      }
    }
  }

  // Calls `visit` with the corners of each facet, counter-clockwise from outside.
  template <class Visit>
  void for_each(Visit visit) {
    std::vector<Vertex> corners;
    for (const Halfedge side : hull_.halfedges()) {
      const std::uint32_t facet = facet_of(side);
      if (seen_[facet] || !on_border(side)) {
        continue;
      }
      seen_[facet] = true;
      corners.clear();
      Halfedge along = side;
      do {
        const Halfedge next = next_on_border(along);
        // Two facets meet in one straight edge, so it is the third that makes a corner.
        if (facet_of(hull_.opposite(along)) != facet_of(hull_.opposite(next))) {
          corners.push_back(hull_.target(along));
        }
        along = next;
      } while (along != side);
      visit(corners);
    }
  }

 private:
  std::uint32_t facet_of(Halfedge side) { return facets_.first(hull_.face(side).idx()); }

  bool on_border(Halfedge side) { return facet_of(side) != facet_of(hull_.opposite(side)); }

  Halfedge next_on_border(Halfedge side) {
    side = hull_.next(side);
    while (!on_border(side)) {
      side = hull_.next(hull_.opposite(side));
    }
    return side;
  }

  const Surface& hull_;
  DisjointSets facets_;
  std::vector<bool> seen_;  // facets, by the number of their set
};

TriangleMesh triangles_of(const Surface& hull) {
  std::vector<std::vector<Vertex>> facets;
  std::vector<Vertex> corners;  // of all facets, from the lowest
  Facets(hull).for_each([&](const std::vector<Vertex>& facet) {
    facets.push_back(facet);
    corners.insert(corners.end(), facet.begin(), facet.end());
  });
  std::ranges::sort(corners, [&](Vertex a, Vertex b) { return hull.point(a) < hull.point(b); });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

  TriangleMesh mesh;
  std::vector<std::uint32_t> numbers(hull.number_of_vertices());
  for (const Vertex corner : corners) {
    numbers[corner.idx()] = static_cast<std::uint32_t>(mesh.positions.size());
    const Kernel::Point_3& p = hull.point(corner);
    mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  const auto number = [&](Vertex vertex) { return numbers[vertex.idx()]; };
  for (std::vector<Vertex>& facet : facets) {
    std::ranges::rotate(facet, std::ranges::min_element(facet, {}, number));
    for (std::size_t i = 2; i < facet.size(); ++i) {
      mesh.triangles.emplace_back(number(facet[0]), number(facet[i - 1]), number(facet[i]));
    }
  }
  std::ranges::sort(mesh.triangles, [](const glm::uvec3& a, const glm::uvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

}  // namespace

TriangleMesh convex_hull(std::span<const glm::dvec3> points) {
  std::vector<Kernel::Point_3> corners;
  corners.reserve(points.size());
  for (const glm::dvec3& p : points) {
    constexpr double unsigned_zero = 0.0;  // which of two equal points stays must not matter
    corners.emplace_back(p.x + unsigned_zero, p.y + unsigned_zero, p.z + unsigned_zero);
  }
  Surface hull;
  CGAL::convex_hull_3(corners.begin(), corners.end(), hull);
  return in_one_plane(hull) ? TriangleMesh() : triangles_of(hull);
}

}  // namespace raycat
