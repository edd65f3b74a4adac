#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "modelling/polygons.hpp"

namespace raycat {

/// A straight edge that raises the winding number by `turns` to its left over that to its right.
struct WindingEdge {
  glm::dvec2 from;
  glm::dvec2 to;
  int turns = 1;
};

/// Appends the edges of a contour.
void add_edges(const Contour& contour, int turns, std::vector<WindingEdge>& out);
void add_edges(const Polygons& polygons, int turns, std::vector<WindingEdge>& out);

/// The region where the winding number of closed rows of edges is at least 1, or `least`. Edges
/// may cross, overlap and be points: the arrangement of all is exact, and the corners of the
/// result are rounded once. No contour passes a corner twice. Throws `std::invalid_argument` if a
/// coordinate is not finite.
Polygons wound_region(std::span<const WindingEdge> edges, int least = 1);

/// The region where it is odd.
Polygons odd_region(std::span<const WindingEdge> edges);

}  // namespace raycat
