#include "modelling/offset.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "modelling/winding.hpp"

namespace raycat {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Goes along contours at a distance to their right. Where edges turn away from it, their offsets
// are joined; where they turn towards it, it goes back to the corner and out again, so that the
// strips beside both edges are wound about once each, and what lies in several more often.
class Offsetter {
 public:
  Offsetter(double distance, Join join, std::uint32_t facets)
      : distance_(distance), join_(join), facet_(2.0 * std::numbers::pi / facets) {}

  void go_round(const Contour& contour, Contour& out) const {
    const std::size_t n = contour.size();
    glm::dvec2 in = outward(contour[n - 1], contour[0]);
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 next = outward(contour[i], contour[(i + 1) % n]);
      turn(contour[i], in, next, out);
      in = next;
    }
  }

 private:
  static glm::dvec2 outward(const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = glm::normalize(to - from);
    return {along.y, -along.x};
  }

  void turn(const glm::dvec2& corner, const glm::dvec2& in, const glm::dvec2& next,
            Contour& out) const {
    const double sine = cross(in, next);
    const double cosine = glm::dot(in, next);
    if (sine * distance_ < 0.0) {
      out.insert(out.end(), {corner + distance_ * in, corner, corner + distance_ * next});
    } else if (join_ == Join::round) {
      add_arc(corner, in, next, std::atan2(sine, cosine), out);
    } else if (join_ == Join::mitre && 1.0 + cosine > sharpest) {
      out.push_back(corner + distance_ / (1.0 + cosine) * (in + next));
    } else {
      // Each offset edge goes on until it is met by the square across.
      const double on = distance_ * std::tan(std::atan2(sine, cosine) / 4.0);
      out.push_back(corner + distance_ * in + on * glm::dvec2(-in.y, in.x));
      out.push_back(corner + distance_ * next - on * glm::dvec2(-next.y, next.x));
    }
  }

  void add_arc(const glm::dvec2& corner, const glm::dvec2& in, const glm::dvec2& next, double angle,
               Contour& out) const {
    const double steps = std::max(std::round(std::abs(angle) / facet_), 1.0);
    for (double step = 0.0; step < steps; ++step) {
      const double turned = std::copysign(step * facet_, angle);
      const glm::dvec2 x(std::cos(turned), std::sin(turned));
      out.push_back(corner +
                    distance_ * glm::dvec2(x.x * in.x - x.y * in.y, x.y * in.x + x.x * in.y));
    }
    out.push_back(corner + distance_ * next);
  }

  static constexpr double sharpest = 2e-12;  // OpenSCAD's limit: mitres up to a million distances
  double distance_;
  Join join_;
  double facet_;
};

}  // namespace

Polygons offset(const Polygons& polygons, double distance, Join join, std::uint32_t facets) {
  const Offsetter offsetter(distance, join, facets);
  std::vector<WindingEdge> edges;
  Contour round;
  for (const Contour& contour : polygons.contours) {
    round.clear();
    offsetter.go_round(contour, round);
    add_edges(round, 1, edges);
  }
  return wound_region(edges);
}

}  // namespace raycat
