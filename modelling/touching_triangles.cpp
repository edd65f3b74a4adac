#include "modelling/touching_triangles.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <fmt/format.h>

namespace raycat {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
constexpr std::size_t most_pairs = std::size_t{1} << 23;  // which are some gigabytes of points

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

// Two triangles with their corners turned so that the common ones come first, in the same places.
struct Pair {
  std::array<Point, 3> a;
  std::array<Point, 3> b;
  int common = 0;
};

Pair aligned(std::array<Point, 3> a, std::array<Point, 3> b) {
  int common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (auto k = static_cast<std::size_t>(common); k < 3; ++k) {
      if (a[i] == b[k]) {
        std::swap(a[i], a[static_cast<std::size_t>(common)]);
        std::swap(b[k], b[static_cast<std::size_t>(common)]);
        ++common;
        break;
      }
    }
  }
  return {.a = a, .b = b, .common = common};
}

bool touch(const Pair& pair) {
  const auto& [a, b, common] = pair;
  switch (common) {
    case 0:
      return CGAL::do_intersect(Kernel::Triangle_3(a[0], a[1], a[2]),
                                Kernel::Triangle_3(b[0], b[1], b[2]));
    case 1:
      return CGAL::do_intersect(Kernel::Segment_3(a[1], a[2]),
                                Kernel::Triangle_3(b[0], b[1], b[2])) ||
             CGAL::do_intersect(Kernel::Segment_3(b[1], b[2]),
                                Kernel::Triangle_3(a[0], a[1], a[2]));
    case 2:  // in one plane, and on one side of the common edge
      return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
             CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
    default:
      return false;
  }
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_triangles(
    std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
    std::span<const std::uint8_t> wanted) {
  const auto corners = [&](std::uint32_t triangle) {
    std::array<Point, 3> points;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3& p = positions[triangles[triangle][k]];
      points[static_cast<std::size_t>(k)] = Point(p.x, p.y, p.z);
    }
    return points;
  };
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (wanted[i] != 0) {
      const auto [a, b, c] = corners(i);
      boxes.emplace_back(a.bbox() + b.bbox() + c.bbox(), i);
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (touch(aligned(corners(a.info()), corners(b.info())))) {
      if (pairs.size() == most_pairs) {
        throw std::length_error(fmt::format(
            "the operands of a solid cut one another at most {} times, triangle by triangle",
            most_pairs));
      }
      pairs.emplace_back(a.info(), b.info());
    }
  });
  return pairs;
}

}  // namespace raycat
