#include "modelling/projection.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/weld.hpp"
#include "modelling/winding.hpp"

namespace raycat {
namespace {

// Where an edge comes through the plane: the same place, whichever triangle asks.
glm::dvec2 crossing(glm::dvec3 a, glm::dvec3 b) {
  if (a.z == 0.0 || b.z == 0.0) {
    return a.z == 0.0 ? a : b;
  }
  if (a.z > b.z) {
    std::swap(a, b);
  }
  return glm::mix(glm::dvec2(a), glm::dvec2(b), a.z / (a.z - b.z));
}

// The section just above the plane, or just below it. Seen from outside and from left to right,
// an edge of each triangle leads down and another up again.
template <typename IsAbove>
Polygons section_beside(const TriangleMesh& mesh, IsAbove is_above) {
  std::vector<WindingEdge> edges;
  for (const glm::uvec3& triangle : mesh.triangles) {
    WindingEdge cut{};
    int crossed = 0;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3& from = mesh.positions[triangle[k]];
      const glm::dvec3& to = mesh.positions[triangle[(k + 1) % 3]];
      if (is_above(from.z) != is_above(to.z)) {
        (is_above(to.z) ? cut.to : cut.from) = crossing(from, to);
        ++crossed;
      }
    }
    if (crossed == 2) {
      edges.push_back(cut);
    }
  }
  return wound_region(edges);
}

bool faces_up(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return CGAL::left_turn(Point(a.x, a.y), Point(b.x, b.y), Point(c.x, c.y));
}

// Those of either sense, each as one that faces up.
Polygons faces_in_plane(const TriangleMesh& mesh, const std::vector<bool>& open_faces) {
  std::vector<WindingEdge> edges;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t face = mesh.faces[i];
    const glm::uvec3& t = mesh.triangles[i];
    const glm::dvec3& a = mesh.positions[t.x];
    const glm::dvec3& b = mesh.positions[t.y];
    const glm::dvec3& c = mesh.positions[t.z];
    const bool is_open = face < open_faces.size() && open_faces[face];
    if (!is_open && a.z == 0.0 && b.z == 0.0 && c.z == 0.0) {
      add_edges(Contour{a, b, c}, faces_up(a, b, c) ? 1 : -1, edges);
    }
  }
  return wound_region(edges);
}

}  // namespace

// What lies in the solid has it on both sides of the plane, or is of a face that lies in it.
Polygons section(const TriangleMesh& closed, const std::vector<bool>& open_faces) {
  const Polygons above = section_beside(closed, [](double z) { return z > 0.0; });
  if (std::ranges::none_of(closed.positions, [](const glm::dvec3& p) { return p.z == 0.0; })) {
    return above;
  }
  const Polygons below = section_beside(closed, [](double z) { return z >= 0.0; });
  const Polygons within = combined(Operation::intersection, std::array{above, below});
  return combined(Operation::set_union, std::array{within, faces_in_plane(closed, open_faces)});
}

// An edge between two triangles that face up is inside the shadow, and is left out.
Polygons shadow(const TriangleMesh& closed) {
  const std::vector<std::uint32_t> place = weld(closed.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> turns;  // from the lower place
  for (const glm::uvec3& t : closed.triangles) {
    const auto& [a, b, c] = std::array{place[t.x], place[t.y], place[t.z]};
    if (!faces_up(closed.positions[a], closed.positions[b], closed.positions[c])) {
      continue;
    }
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      turns[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  std::vector<WindingEdge> edges;
  for (const auto& [ends, count] : turns) {
    if (count != 0) {
      edges.push_back({closed.positions[ends.first], closed.positions[ends.second], count});
    }
  }
  return wound_region(edges);
}

}  // namespace raycat
