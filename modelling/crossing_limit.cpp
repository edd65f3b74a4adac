#include "modelling/crossing_limit.hpp"

#include <cstdint>
#include <stdexcept>
#include <vector>

#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace raycat {
namespace {

using EdgeBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, const WindingEdge*>;

// Twice the area, from which nothing but a count depends.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 ab = b - a;
  const glm::dvec2 ac = c - a;
  return ab.x * ac.y - ab.y * ac.x;
}

// Edges in one line cost as much where they overlap.
bool cross(const WindingEdge& a, const WindingEdge& b) {
  const double b_from = turn(a.from, a.to, b.from);
  const double b_to = turn(a.from, a.to, b.to);
  if (b_from == 0.0 && b_to == 0.0) {
    return true;
  }
  return b_from * b_to < 0.0 && turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) < 0.0;
}

}  // namespace

void require_few_crossings(std::span<const WindingEdge> edges) {
  constexpr std::int64_t most_crossings = 200'000;
  constexpr std::int64_t most_neighbours = 100'000'000;
  std::vector<EdgeBox> boxes;
  boxes.reserve(edges.size());
  for (const WindingEdge& edge : edges) {
    const CGAL::Bbox_2 box = CGAL::Bbox_2(edge.from.x, edge.from.y, edge.from.x, edge.from.y) +
                             CGAL::Bbox_2(edge.to.x, edge.to.y, edge.to.x, edge.to.y);
    boxes.emplace_back(box, &edge);
  }
  std::int64_t crossings = 0;
  std::int64_t neighbours = 0;
  CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(), [&](const EdgeBox& a, const EdgeBox& b) {
        crossings += cross(*a.info(), *b.info()) ? 1 : 0;
        if (crossings > most_crossings || ++neighbours > most_neighbours) {
          throw std::length_error("polygons cross each other in too many places");
        }
      });
}

}  // namespace raycat
