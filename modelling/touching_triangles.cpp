#include "modelling/touching_triangles.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <fmt/format.h>

namespace raycat {
namespace {

// Faster where all corners are doubles.
using Doubles = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr std::size_t most_pairs = std::size_t{1} << 23;  // which are some gigabytes of points

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

// Two triangles with their corners turned so that the common ones come first, in the same places.
template <typename Kernel>
struct Pair {
  std::array<typename Kernel::Point_3, 3> a;
  std::array<typename Kernel::Point_3, 3> b;
  int common = 0;
};

template <typename Kernel>
Pair<Kernel> aligned(std::array<typename Kernel::Point_3, 3> a,
                     std::array<typename Kernel::Point_3, 3> b) {
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

template <typename Kernel>
bool touch(const Pair<Kernel>& pair) {
  using Segment = typename Kernel::Segment_3;
  using Triangle = typename Kernel::Triangle_3;
  const auto& [a, b, common] = pair;
  switch (common) {
    case 0:
      return CGAL::do_intersect(Triangle(a[0], a[1], a[2]), Triangle(b[0], b[1], b[2]));
    case 1:
      return CGAL::do_intersect(Segment(a[1], a[2]), Triangle(b[0], b[1], b[2])) ||
             CGAL::do_intersect(Segment(b[1], b[2]), Triangle(a[0], a[1], a[2]));
    case 2:  // in one plane, and on one side of the common edge
      return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
             CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
    default:
      return false;
  }
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> touching_triangles(
    std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
    std::span<const std::uint8_t> wanted) {
  std::vector<Doubles::Point_3> doubles;
  std::vector<std::uint8_t> is_double;
  for (const Exact::Point_3& point : points) {
    const glm::dvec3 p = rounded(point);
    doubles.emplace_back(p.x, p.y, p.z);
    is_double.push_back(exact(p) == point ? 1 : 0);
  }
  const auto corners = [&](const auto& of, std::uint32_t triangle) {
    const glm::uvec3& t = triangles[triangle];
    return std::array{of[t.x], of[t.y], of[t.z]};
  };
  const auto all_doubles = [&](std::uint32_t triangle) {
    const glm::uvec3& t = triangles[triangle];
    return is_double[t.x] != 0 && is_double[t.y] != 0 && is_double[t.z] != 0;
  };
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (wanted[i] != 0) {
      const auto [a, b, c] = corners(points, i);
      boxes.emplace_back(a.bbox() + b.bbox() + c.bbox(), i);
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const bool do_touch =
        all_doubles(a.info()) && all_doubles(b.info())
            ? touch(aligned<Doubles>(corners(doubles, a.info()), corners(doubles, b.info())))
            : touch(aligned<Exact>(corners(points, a.info()), corners(points, b.info())));
    if (!do_touch) {
      return;
    }
    if (pairs.size() == most_pairs) {
      throw std::length_error(fmt::format(
          "the operands of a solid cut one another at most {} times, triangle by triangle",
          most_pairs));
    }
    pairs.emplace_back(a.info(), b.info());
  });
  return pairs;
}

}  // namespace raycat
