#include "modelling/arrangement.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "modelling/touching_triangles.hpp"
#include "modelling/triangle_overlap.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t unnumbered = ~std::uint32_t{0};

// Knows each point by one number, however it came about.
class PointNumbers {
 public:
  explicit PointNumbers(std::vector<Exact::Point_3>& points) : points_(points) {}

  std::uint32_t operator()(const RationalPoint& point) {
    const std::array key{CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                         CGAL::to_double(point.z())};
    const auto [begin, end] = numbers_.equal_range(key);
    for (auto known = begin; known != end; ++known) {
      if (CGAL::exact(points_[known->second]) == point) {
        return known->second;
      }
    }
    const auto number = static_cast<std::uint32_t>(points_.size());
    numbers_.emplace(key, number);
    points_.emplace_back(Exact::FT(point.x()), Exact::FT(point.y()), Exact::FT(point.z()));
    return number;
  }

 private:
  struct Hash {
    std::size_t operator()(const std::array<double, 3>& key) const {
      std::size_t hash = 0;
      for (const double part : key) {
        hash = 0x9e3779b97f4a7c15U * (hash ^ std::hash<double>()(part)) + (hash >> 29U);
      }
      return hash;
    }
  };

  std::vector<Exact::Point_3>& points_;
  std::unordered_multimap<std::array<double, 3>, std::uint32_t, Hash> numbers_;
};

// What is drawn on a triangle.
struct Drawing {
  std::vector<std::uint32_t> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> segments;

  void add(const std::vector<TriangleOverlap::Segment>& drawn, PointNumbers& number) {
    for (const auto& [from, to] : drawn) {
      const std::uint32_t begin = number(from);
      const std::uint32_t end = number(to);
      if (begin == end) {
        points.push_back(begin);
      } else {
        segments.emplace_back(begin, end);
      }
    }
  }
};

// The triangle's plane, seen along the axis that it faces most.
class Plane {
 public:
  Plane(const Exact::Point_3& a, const Exact::Point_3& b, const Exact::Point_3& c) : origin_(a) {
    const Exact::Vector_3 normal = CGAL::cross_product(b - a, c - a);
    for (int axis = 0; axis < 3; ++axis) {
      normal_[static_cast<std::size_t>(axis)] = normal[axis];
      if (CGAL::abs(normal[axis]) > CGAL::abs(normal[axis_])) {
        axis_ = axis;
      }
    }
  }

  // Does the triangle run the other way when seen so?
  bool turned() const { return CGAL::is_negative(normal_[at(axis_)]); }

  Exact::Point_2 flat(const Exact::Point_3& p) const {
    return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]};
  }

  Exact::Point_3 raised(const Exact::Point_2& p) const {
    const int u = (axis_ + 1) % 3;
    const int v = (axis_ + 2) % 3;
    std::array<Exact::FT, 3> out;
    out[at(u)] = p.x();
    out[at(v)] = p.y();
    out[at(axis_)] = origin_[axis_] - (normal_[at(u)] * (p.x() - origin_[u]) +
                                       normal_[at(v)] * (p.y() - origin_[v])) /
                                          normal_[at(axis_)];
    return {out[0], out[1], out[2]};
  }

 private:
  static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

  Exact::Point_3 origin_;
  std::array<Exact::FT, 3> normal_;
  int axis_ = 0;
};

struct VertexNumber {
  std::uint32_t value = unnumbered;
};

using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Exact,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<VertexNumber, Exact>,
        CGAL::Constrained_triangulation_face_base_2<Exact>>,
    CGAL::Exact_intersections_tag>;

void cut(const glm::uvec3& corners, std::uint32_t triangle, Drawing& drawing, PointNumbers& number,
         Arrangement& out) {
  for (int k = 0; k < 3; ++k) {
    drawing.points.push_back(corners[k]);
    drawing.segments.emplace_back(corners[k], corners[(k + 1) % 3]);
  }
  for (auto& [from, to] : drawing.segments) {
    drawing.points.insert(drawing.points.end(), {from, to});
    if (from > to) {
      std::swap(from, to);
    }
  }
  std::ranges::sort(drawing.points);
  drawing.points.erase(std::unique(drawing.points.begin(), drawing.points.end()),
                       drawing.points.end());
  std::ranges::sort(drawing.segments);
  drawing.segments.erase(std::unique(drawing.segments.begin(), drawing.segments.end()),
                         drawing.segments.end());

  const Plane plane(out.points[corners.x], out.points[corners.y], out.points[corners.z]);
  std::vector<std::pair<Exact::Point_2, VertexNumber>> flat;
  for (const std::uint32_t point : drawing.points) {
    flat.emplace_back(plane.flat(out.points[point]), VertexNumber{point});
  }
  Triangulation triangulation;
  triangulation.insert(flat.begin(), flat.end());
  std::map<std::uint32_t, Triangulation::Vertex_handle> vertex_of;
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    vertex_of[vertex->info().value] = vertex;
  }
  for (const auto& [from, to] : drawing.segments) {
    triangulation.insert_constraint(vertex_of.at(from), vertex_of.at(to));
  }
  // Where segments cross there are new vertices, made without a number.
  for (const auto vertex : triangulation.finite_vertex_handles()) {
    if (vertex->info().value == unnumbered) {
      vertex->info().value = number(CGAL::exact(plane.raised(vertex->point())));
    }
  }
  for (const auto face : triangulation.finite_face_handles()) {
    glm::uvec3 piece(face->vertex(0)->info().value, face->vertex(1)->info().value,
                     face->vertex(2)->info().value);
    if (plane.turned()) {
      std::swap(piece.y, piece.z);
    }
    out.pieces.push_back({.corners = piece, .triangle = triangle});
  }
}

}  // namespace

Arrangement arrange(std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
                    std::span<const std::uint8_t> wanted) {
  Arrangement out;
  PointNumbers number(out.points);
  std::vector<std::uint32_t> number_of(points.size(), unnumbered);
  std::vector<glm::uvec3> corners(triangles.size(), glm::uvec3(unnumbered));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; wanted[i] != 0 && k < 3; ++k) {
      std::uint32_t& id = number_of[triangles[i][k]];
      if (id == unnumbered) {
        id = number(CGAL::exact(points[triangles[i][k]]));
      }
      corners[i][k] = id;
    }
  }
  std::vector<std::uint32_t> drawing_of(triangles.size(), unnumbered);
  std::vector<Drawing> drawings;
  const auto drawing = [&](std::uint32_t triangle) {
    if (drawing_of[triangle] == unnumbered) {
      drawing_of[triangle] = static_cast<std::uint32_t>(drawings.size());
      drawings.emplace_back();
    }
    return drawing_of[triangle];
  };
  const auto exact_triangle = [&](std::uint32_t triangle) {
    const glm::uvec3& t = corners[triangle];
    return std::array{CGAL::exact(out.points[t.x]), CGAL::exact(out.points[t.y]),
                      CGAL::exact(out.points[t.z])};
  };
  for (const auto& [a, b] : touching_triangles(points, triangles, wanted)) {
    const std::uint32_t first = drawing(a);
    const std::uint32_t second = drawing(b);
    const TriangleOverlap overlap = triangle_overlap(exact_triangle(a), exact_triangle(b));
    drawings[first].add(overlap.on_a, number);
    drawings[second].add(overlap.on_b, number);
  }
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (wanted[i] == 0) {
      continue;
    }
    if (drawing_of[i] == unnumbered) {
      out.pieces.push_back({.corners = corners[i], .triangle = i});
    } else {
      cut(corners[i], i, drawings[drawing_of[i]], number, out);
      drawings[drawing_of[i]] = {};
    }
  }
  return out;
}

}  // namespace raycat
