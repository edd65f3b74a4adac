#include "geometry/edge_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/bounds.hpp"
#include "geometry/edge_uses.hpp"
#include "geometry/exactly_between.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

constexpr std::size_t most_on_edge = 64;

int longest_axis(const glm::dvec3& size) {
  return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

struct NumberedPoint {
  glm::dvec3 at;
  std::uint32_t vertex;
};

/// Points halved again and again along the longest side of their box.
class PointTree {
 public:
  explicit PointTree(std::vector<NumberedPoint> points)
      : points_(std::move(points)), cuts_(points_.size()) {
    build(0, points_.size());
  }

  /// All points; those near each other are mostly close together.
  std::span<const NumberedPoint> points() const noexcept { return points_; }

  /// Calls `visit` with the points that may be as near to the segment from `a` to `b` as `reach`.
  template <typename Visit>
  void near(const glm::dvec3& a, const glm::dvec3& b, double reach, const Visit& visit) const {
    near(0, points_.size(), a, b, reach, visit);
  }

 private:
  struct Cut {
    int axis = 0;
    double at = 0.0;
  };

  static constexpr std::size_t leaf = 8;

  void build(std::size_t begin, std::size_t end) {
    if (end - begin <= leaf) {
      return;
    }
    Bounds box;
    for (std::size_t i = begin; i < end; ++i) {
      box.include(points_[i].at);
    }
    const int axis = longest_axis(box.max - box.min);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto point = [&](std::size_t i) {
      return points_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(
        point(begin), point(middle), point(end),
        [axis](const NumberedPoint& p, const NumberedPoint& q) { return p.at[axis] < q.at[axis]; });
    cuts_[middle] = {.axis = axis, .at = points_[middle].at[axis]};
    build(begin, middle);
    build(middle, end);
  }

  // The part of the segment that is left has its ends at `a` and `b`.
  template <typename Visit>
  void near(std::size_t begin, std::size_t end, const glm::dvec3& a, const glm::dvec3& b,
            double reach, const Visit& visit) const {
    if (end - begin <= leaf) {
      for (std::size_t i = begin; i < end; ++i) {
        visit(points_[i]);
      }
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto [axis, cut] = cuts_[middle];
    const bool rises = a[axis] <= b[axis];
    const glm::dvec3& least = rises ? a : b;
    const glm::dvec3& most = rises ? b : a;
    if (least[axis] <= cut + reach) {
      near(begin, middle, least, up_to(least, most, axis, cut + reach), reach, visit);
    }
    if (most[axis] >= cut - reach) {
      near(middle, end, up_to(most, least, axis, cut - reach), most, reach, visit);
    }
  }

  // `to`, or the point before it at which the segment from `from` meets the plane.
  static glm::dvec3 up_to(const glm::dvec3& from, const glm::dvec3& to, int axis, double plane) {
    const bool passes_up = from[axis] < to[axis] && to[axis] > plane;
    const bool passes_down = from[axis] > to[axis] && to[axis] < plane;
    if (!passes_up && !passes_down) {
      return to;
    }
    glm::dvec3 at = glm::mix(from, to, (plane - from[axis]) / (to[axis] - from[axis]));
    at[axis] = plane;
    return at;
  }

  std::vector<NumberedPoint> points_;
  std::vector<Cut> cuts_;  // before each point that is the first of an upper half
};

bool finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::vector<NumberedPoint> ends_of(std::span<const glm::dvec3> positions,
                                   std::span<const glm::uvec3> welded,
                                   std::span<const std::uint32_t> half_edges) {
  std::vector<std::uint32_t> ends;
  ends.reserve(2 * half_edges.size());
  for (const std::uint32_t half : half_edges) {
    ends.push_back(half_edge_start(welded, half));
    ends.push_back(half_edge_end(welded, half));
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<NumberedPoint> points;
  points.reserve(ends.size());
  for (const std::uint32_t end : ends) {
    if (finite(positions[end])) {
      points.push_back({.at = positions[end], .vertex = end});
    }
  }
  return points;
}

double greatest_coordinate(const Bounds& box) {
  const glm::dvec3 most = glm::max(glm::abs(box.min), glm::abs(box.max));
  return std::max({most.x, most.y, most.z});
}

Bounds bounds_of(std::span<const glm::dvec3> positions) {
  Bounds box;
  for (const glm::dvec3& position : positions) {
    box.include(position);
  }
  return box;
}

// A vertex on the inside of an edge.
struct OnEdge {
  std::size_t edge = 0;  // among the half-edges given
  double t = 0.0;
  double along = 0.0;  // by which they are sorted: exactly, if the vertex is on the edge exactly
  std::uint32_t vertex = 0;
};

// The numbers of half-edges in the order in which the tree has their starts, for the sake of
// caches.
std::vector<std::uint64_t> in_order_of(const PointTree& tree, std::span<const glm::uvec3> welded,
                                       std::span<const std::uint32_t> half_edges,
                                       std::size_t vertices) {
  std::vector<std::uint32_t> place(vertices);
  for (std::uint32_t i = 0; i < tree.points().size(); ++i) {
    place[tree.points()[i].vertex] = i;
  }
  std::vector<std::uint64_t> order(half_edges.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = std::uint64_t{place[half_edge_start(welded, half_edges[i])]} << 32U | i;
  }
  std::ranges::sort(order);
  for (std::uint64_t& entry : order) {
    entry &= 0xffffffffU;
  }
  return order;
}

// Of the edges that `order` names, cut short past `most`.
std::vector<OnEdge> on_edges(std::span<const glm::dvec3> positions,
                             std::span<const glm::uvec3> welded,
                             std::span<const std::uint32_t> half_edges, const PointTree& tree,
                             double tolerance, double reach, std::span<const std::uint64_t> order,
                             std::size_t most) {
  std::vector<OnEdge> out;
  for (const std::uint64_t i : order) {
    if (out.size() > most) {
      break;
    }
    const std::uint32_t start = half_edge_start(welded, half_edges[i]);
    const std::uint32_t stop = half_edge_end(welded, half_edges[i]);
    const glm::dvec3& a = positions[start];
    const glm::dvec3& b = positions[stop];
    const glm::dvec3 edge = b - a;
    const int axis = longest_axis(glm::abs(edge));
    tree.near(a, b, reach, [&](const NumberedPoint& point) {
      const glm::dvec3 to = point.at - a;
      const double t = glm::dot(to, edge) / glm::dot(edge, edge);
      const bool is_inside =
          point.vertex != start && point.vertex != stop &&
          (tolerance > 0.0 ? t > 0.0 && t < 1.0 && glm::length(to - t * edge) <= tolerance
                           : exactly_between(point.at, a, b));
      if (is_inside) {
        out.push_back({.edge = i,
                       .t = t,
                       .along = edge[axis] < 0.0 ? -point.at[axis] : point.at[axis],
                       .vertex = point.vertex});
      }
    });
  }
  return out;
}

EdgePart part_between(std::uint32_t from, double from_t, std::uint32_t to, double to_t,
                      std::uint32_t half) {
  return {.low = std::min(from, to),
          .high = std::max(from, to),
          .half = half,
          .upwards = from < to,
          .from = from_t,
          .to = to_t};
}

}  // namespace

double edge_tolerance(std::span<const glm::dvec3> positions) {
  const Bounds box = bounds_of(positions);
  const double by_size = 1e-6 * glm::length(box.half_size());
  const bool floats = std::ranges::all_of(
      positions, [](const glm::dvec3& p) { return glm::dvec3(glm::vec3(p)) == p; });
  // Three points move, each by the half of an ulp along three axes.
  const double by_rounding = 2.0 * std::numeric_limits<float>::epsilon() * greatest_coordinate(box);
  return floats ? std::max(by_size, by_rounding) : by_size;
}

std::vector<EdgePart> edge_parts(std::span<const glm::dvec3> positions,
                                 std::span<const glm::uvec3> welded,
                                 std::span<const std::uint32_t> half_edges, double tolerance,
                                 int threads) {
  std::vector<NumberedPoint> ends = ends_of(positions, welded, half_edges);
  Bounds box;
  for (const NumberedPoint& end : ends) {
    box.include(end.at);
  }
  // Beyond what rounding makes of the distance.
  const double reach = std::max(tolerance, 1e-14 * greatest_coordinate(box));
  const PointTree tree(std::move(ends));
  const std::vector<std::uint64_t> order = in_order_of(tree, welded, half_edges, positions.size());
  const std::size_t most = most_on_edge * half_edges.size();
  std::vector<std::vector<OnEdge>> found(
      static_cast<std::size_t>(part_count(half_edges.size(), threads)));
  parallel_parts(half_edges.size(), threads, [&](std::size_t begin, std::size_t end, int part) {
    found[static_cast<std::size_t>(part)] =
        on_edges(positions, welded, half_edges, tree, tolerance, reach,
                 std::span(order).subspan(begin, end - begin), most);
  });
  std::vector<OnEdge> inside;
  for (const std::vector<OnEdge>& of_part : found) {
    inside.insert(inside.end(), of_part.begin(), of_part.end());
  }
  if (inside.empty() || inside.size() > most) {
    return {};
  }
  std::ranges::sort(inside, {}, [](const OnEdge& point) {
    return std::tuple(point.edge, point.along, point.vertex);
  });
  std::vector<EdgePart> parts;
  parts.reserve(half_edges.size() + inside.size());
  auto next = inside.begin();
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    std::uint32_t from = half_edge_start(welded, half_edges[i]);
    double from_t = 0.0;
    for (; next != inside.end() && next->edge == i; ++next) {
      parts.push_back(part_between(from, from_t, next->vertex, next->t, half_edges[i]));
      from = next->vertex;
      from_t = next->t;
    }
    parts.push_back(
        part_between(from, from_t, half_edge_end(welded, half_edges[i]), 1.0, half_edges[i]));
  }
  std::ranges::sort(
      parts, {}, [](const EdgePart& part) { return std::tuple(part.low, part.high, part.half); });
  return parts;
}

}  // namespace raycat
