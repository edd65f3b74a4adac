#include "modelling/triangulation.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "modelling/winding.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Face {
  int winding = 0;
  bool reached = false;
};

using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Faces =
    CGAL::Triangulation_face_base_with_info_2<Face, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

// How often contours run from the lower to the higher corner, less how often back.
class Turns {
 public:
  void add(std::uint32_t from, std::uint32_t to) { turns_[key(from, to)] += from < to ? 1 : -1; }
  int along(std::uint32_t from, std::uint32_t to) const {
    const auto found = turns_.find(key(from, to));
    return found == turns_.end() ? 0 : (from < to ? found->second : -found->second);
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }
  std::unordered_map<std::uint64_t, int> turns_;
};

// The corners, first to last, and each contour's edges between them.
struct Graph {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

Graph graph(const Polygons& polygons) {
  Graph out;
  for (const Contour& contour : polygons.contours) {
    const std::size_t first = out.corners.size();
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const auto number = static_cast<std::uint32_t>(out.corners.size());
      out.corners.emplace_back(Kernel::Point_2(contour[i].x, contour[i].y), number);
      out.edges.emplace_back(first + i, first + (i + 1) % contour.size());
    }
  }
  return out;
}

void wind(Delaunay& delaunay, const Turns& turns) {
  std::vector<Delaunay::Face_handle> waiting{delaunay.infinite_face()};
  delaunay.infinite_face()->info().reached = true;
  while (!waiting.empty()) {
    const Delaunay::Face_handle face = waiting.back();
    waiting.pop_back();
    for (int i = 0; i < 3; ++i) {
      Face& beyond = face->neighbor(i)->info();
      if (beyond.reached) {
        continue;
      }
      beyond.reached = true;
      beyond.winding = face->info().winding;
      if (face->is_constrained(i)) {
        beyond.winding -= turns.along(face->vertex(Delaunay::ccw(i))->info(),
                                      face->vertex(Delaunay::cw(i))->info());
      }
      waiting.push_back(face->neighbor(i));
    }
  }
}

// Nothing if an edge crosses another or passes through a corner.
std::optional<std::vector<glm::uvec3>> triangles(const Polygons& polygons) {
  const Graph input = graph(polygons);
  Delaunay delaunay;
  delaunay.insert(input.corners.begin(), input.corners.end());
  std::vector<Delaunay::Vertex_handle> vertices(input.corners.size());
  Delaunay::Face_handle near;
  for (std::size_t i = 0; i < input.corners.size(); ++i) {
    vertices[i] = delaunay.insert(input.corners[i].first, near);
    near = vertices[i]->face();
  }
  Turns turns;
  try {
    for (const auto& [from, to] : input.edges) {
      if (vertices[from] != vertices[to]) {
        delaunay.insert_constraint(vertices[from], vertices[to]);
      }
    }
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  for (const auto& [from, to] : input.edges) {
    if (vertices[from] != vertices[to]) {
      if (!delaunay.is_edge(vertices[from], vertices[to])) {
        return std::nullopt;
      }
      turns.add(vertices[from]->info(), vertices[to]->info());
    }
  }
  std::vector<glm::uvec3> out;
  if (delaunay.dimension() < 2) {
    return out;
  }
  wind(delaunay, turns);
  for (const Delaunay::Face_handle face : delaunay.finite_face_handles()) {
    // Regular polygons wind about everything once or not at all, but rounding may have turned a
    // sliver over.
    const int winding = face->info().winding;
    const int next = winding > 0 ? 1 : 2;
    for (int i = 0; i < std::abs(winding); ++i) {
      out.emplace_back(face->vertex(0)->info(), face->vertex(next)->info(),
                       face->vertex(3 - next)->info());
    }
  }
  return out;
}

}  // namespace

Triangulation triangulated(Polygons polygons) {
  constexpr int most_attempts = 8;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (auto found = triangles(polygons)) {
      return {std::move(polygons), std::move(*found)};
    }
    std::vector<WindingEdge> edges;
    add_edges(polygons, 1, edges);
    polygons = wound_region(edges);
  }
  throw std::runtime_error("a polygon's edges lie too close for double precision");
}

}  // namespace raycat
