#include "modelling/triangle_overlap.hpp"

#include <cstddef>
#include <utility>

namespace raycat {
namespace {

using Rational = Exact::Exact_kernel::FT;
using Vector = Exact::Exact_kernel::Vector_3;
using Corners = std::array<RationalPoint, 3>;

int sign(const Rational& number) { return static_cast<int>(CGAL::sign(number)); }

// The point between two that lie on different sides of a plane, by their distances from it.
RationalPoint between(const RationalPoint& p, const RationalPoint& q, const Rational& distance_p,
                      const Rational& distance_q) {
  return p + (q - p) * (distance_p / (distance_p - distance_q));
}

// Where a triangle meets the plane from which its corners have these distances: one point, the ends
// of a segment, or nothing.
std::vector<RationalPoint> on_plane(const Corners& corners,
                                    const std::array<Rational, 3>& distance) {
  std::vector<RationalPoint> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (sign(distance[i]) == 0) {
      ends.push_back(corners[i]);
    } else if (sign(distance[i]) * sign(distance[next]) < 0) {
      ends.push_back(between(corners[i], corners[next], distance[i], distance[next]));
    }
  }
  return ends;
}

// The common part of two segments of one line, or points on it.
std::vector<TriangleOverlap::Segment> common(std::vector<RationalPoint> a,
                                             std::vector<RationalPoint> b) {
  if (a.empty() || b.empty()) {
    return {};
  }
  if (a.back() < a.front()) {
    std::swap(a.front(), a.back());
  }
  if (b.back() < b.front()) {
    std::swap(b.front(), b.back());
  }
  const RationalPoint& begin = a.front() < b.front() ? b.front() : a.front();
  const RationalPoint& end = a.back() < b.back() ? a.back() : b.back();
  return end < begin ? std::vector<TriangleOverlap::Segment>()
                     : std::vector<TriangleOverlap::Segment>{{begin, end}};
}

// Twice the area of a triangle as seen along an axis.
Rational flat_area(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                   int axis) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

// Adds the part of a segment that lies in a triangle of its plane.
void clip(const RationalPoint& p, const RationalPoint& q, const Corners& triangle, int axis,
          bool turned, std::vector<TriangleOverlap::Segment>& out) {
  Rational begin = 0;
  Rational end = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint& from = triangle[turned ? (i + 1) % 3 : i];
    const RationalPoint& to = triangle[turned ? i : (i + 1) % 3];
    const Rational at_p = flat_area(from, to, p, axis);
    const Rational at_q = flat_area(from, to, q, axis);
    const bool p_outside = sign(at_p) < 0;
    const bool q_outside = sign(at_q) < 0;
    if (p_outside && q_outside) {
      return;
    }
    if (p_outside || q_outside) {
      const Rational crossing = at_p / (at_p - at_q);
      if (p_outside && begin < crossing) {
        begin = crossing;
      } else if (q_outside && crossing < end) {
        end = crossing;
      }
    }
  }
  if (end < begin) {
    return;
  }
  const auto at = [&](const Rational& t) { return t == 0 ? p : t == 1 ? q : p + (q - p) * t; };
  out.push_back({at(begin), at(end)});
}

void draw_edges(const Corners& edges, const Corners& on, int axis,
                std::vector<TriangleOverlap::Segment>& out) {
  const bool turned = sign(flat_area(on[0], on[1], on[2], axis)) < 0;
  for (std::size_t i = 0; i < 3; ++i) {
    clip(edges[i], edges[(i + 1) % 3], on, axis, turned, out);
  }
}

Vector normal(const Corners& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]); }

std::array<Rational, 3> distances(const Corners& corners, const RationalPoint& origin,
                                  const Vector& normal) {
  return {(corners[0] - origin) * normal, (corners[1] - origin) * normal,
          (corners[2] - origin) * normal};
}

}  // namespace

TriangleOverlap triangle_overlap(const Corners& a, const Corners& b) {
  const Vector normal_a = normal(a);
  const std::array<Rational, 3> from_a = distances(b, a[0], normal_a);
  TriangleOverlap out;
  if (sign(from_a[0]) == 0 && sign(from_a[1]) == 0 && sign(from_a[2]) == 0) {
    const int axis = sign(normal_a.x()) != 0 ? 0 : sign(normal_a.y()) != 0 ? 1 : 2;
    draw_edges(b, a, axis, out.on_a);
    draw_edges(a, b, axis, out.on_b);
    return out;
  }
  out.on_a = common(on_plane(b, from_a), on_plane(a, distances(a, b[0], normal(b))));
  out.on_b = out.on_a;
  return out;
}

}  // namespace raycat
