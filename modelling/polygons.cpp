#include "modelling/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include "modelling/winding.hpp"

namespace raycat {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

double signed_area(const Contour& contour) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
    sum += cross(contour[i] - contour[0], contour[i + 1] - contour[0]);
  }
  return 0.5 * sum;
}

}  // namespace

Polygons even_odd(std::span<const Contour> contours) {
  std::vector<WindingEdge> edges;
  for (const Contour& contour : contours) {
    add_edges(contour, 1, edges);
  }
  return odd_region(edges);
}

// All that the first holds and nothing else does is where the others, running backwards, leave a
// winding number of 1; what all n hold is where one more than n - 1 are.
Polygons combined(Operation operation, std::span<const Polygons> operands) {
  std::vector<WindingEdge> edges;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    add_edges(operands[i], operation == Operation::difference && i > 0 ? -1 : 1, edges);
  }
  const bool all = operation == Operation::intersection && !operands.empty();
  return wound_region(edges, all ? static_cast<int>(operands.size()) : 1);
}

Polygons transformed(const Polygons& polygons, const glm::dmat3x2& map) {
  const double turn = cross(map[0], map[1]);
  Polygons out;
  if (turn == 0.0) {
    return out;
  }
  out.contours.reserve(polygons.contours.size());
  for (const Contour& contour : polygons.contours) {
    Contour& image = out.contours.emplace_back();
    image.reserve(contour.size());
    for (const glm::dvec2& p : contour) {
      const glm::dvec2 q = map[0] * p.x + map[1] * p.y + map[2];
      if (!std::isfinite(q.x) || !std::isfinite(q.y)) {
        throw std::invalid_argument("a polygon has a corner that is not finite");
      }
      image.push_back(q);
    }
    if (turn < 0.0) {
      std::ranges::reverse(image);
    }
  }
  return out;
}

Polygons hull(std::span<const Polygons> operands) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> points;
  for (const Polygons& polygons : operands) {
    for (const Contour& contour : polygons.contours) {
      for (const glm::dvec2& p : contour) {
        points.emplace_back(p.x, p.y);
      }
    }
  }
  std::vector<Point> corners;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
  Polygons out;
  if (corners.size() > 2) {
    Contour& contour = out.contours.emplace_back();
    for (const Point& p : corners) {
      contour.emplace_back(p.x(), p.y());
    }
  }
  return out;
}

Polygons filled(const Polygons& polygons) {
  std::vector<WindingEdge> edges;
  for (const Contour& contour : polygons.contours) {
    if (signed_area(contour) > 0.0) {
      add_edges(contour, 1, edges);
    }
  }
  return wound_region(edges);
}

double area(const Polygons& polygons) {
  double sum = 0.0;
  for (const Contour& contour : polygons.contours) {
    sum += signed_area(contour);
  }
  return sum;
}

}  // namespace raycat
