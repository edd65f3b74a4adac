#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <fmt/format.h>

#include "geometry/disjoint_sets.hpp"
#include "modelling/polygons.hpp"
#include "modelling/triangulation.hpp"
#include "modelling/winding.hpp"

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Simple = CGAL::Polygon_2<Kernel>;
using Piece = CGAL::Polygon_with_holes_2<Kernel>;

// Corners at one place have one number.
std::vector<std::size_t> places(const Polygons& polygons) {
  std::map<std::pair<double, double>, std::size_t> known;
  std::vector<std::size_t> out;
  for (const Contour& contour : polygons.contours) {
    for (const glm::dvec2& p : contour) {
      out.push_back(known.try_emplace({p.x, p.y}, known.size()).first->second);
    }
  }
  return out;
}

Simple simple(const Contour& contour) {
  Simple out;
  for (const glm::dvec2& p : contour) {
    out.push_back({p.x, p.y});
  }
  return out;
}

// Each outer contour with its holes: contours belong together if triangles between them do.
std::vector<Piece> pieces(const Polygons& polygons) {
  const auto [regular, triangles] = triangulated(polygons);
  const std::vector<std::size_t> place = places(regular);
  DisjointSets joined(triangles.size());
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> left;  // triangle left of an edge
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t from = place[triangles[i][k]];
      const std::size_t to = place[triangles[i][(k + 1) % 3]];
      left[{from, to}] = i;
      if (const auto twin = left.find({to, from}); twin != left.end()) {
        joined.join(i, twin->second);
      }
    }
  }
  std::map<std::uint32_t, std::pair<Simple, std::vector<Simple>>> grouped;
  std::size_t first = 0;
  for (const Contour& contour : regular.contours) {
    const auto beside = left.find({place[first], place[first + 1]});
    first += contour.size();
    if (beside == left.end()) {
      continue;
    }
    auto& [outer, holes] = grouped[joined.first(beside->second)];
    Simple polygon = simple(contour);
    if (polygon.is_counterclockwise_oriented()) {
      outer = std::move(polygon);
    } else {
      holes.push_back(std::move(polygon));
    }
  }
  std::vector<Piece> out;
  for (auto& [set, piece] : grouped) {
    out.emplace_back(std::move(piece.first), piece.second.begin(), piece.second.end());
  }
  return out;
}

void add_contour(const Simple& polygon, std::vector<WindingEdge>& out) {
  Contour contour;
  for (const Kernel::Point_2& p : polygon.container()) {
    contour.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }
  add_edges(contour, 1, out);
}

std::size_t corners(const Piece& piece) {
  std::size_t sum = piece.outer_boundary().size();
  for (const Simple& hole : piece.holes()) {
    sum += hole.size();
  }
  return sum;
}

bool is_convex(const Piece& piece) {
  return piece.number_of_holes() == 0 && piece.outer_boundary().is_convex();
}

// What is not convex costs a sum of edges for each two of them, and those cross.
void check_size(const Piece& p, const Piece& q) {
  const std::size_t most = is_convex(p) || is_convex(q) ? 1'000'000 : 100'000;
  if (corners(p) > most / corners(q)) {
    throw std::length_error(fmt::format(
        "a Minkowski sum of polygons with {} and {} corners is too large", corners(p), corners(q)));
  }
}

}  // namespace

Polygons minkowski_sum(const Polygons& a, const Polygons& b) {
  const std::vector<Piece> of_a = pieces(a);
  const std::vector<Piece> of_b = pieces(b);
  std::vector<WindingEdge> edges;
  for (const Piece& p : of_a) {
    for (const Piece& q : of_b) {
      check_size(p, q);
      const Piece sum = CGAL::minkowski_sum_2(p, q);
      add_contour(sum.outer_boundary(), edges);
      for (const Simple& hole : sum.holes()) {
        add_contour(hole, edges);
      }
    }
  }
  return wound_region(edges);
}

}  // namespace raycat
