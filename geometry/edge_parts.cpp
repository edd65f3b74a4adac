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

/// Points halved again and again along the longest side of their box.
class PointTree {
 public:
  PointTree(std::span<const glm::dvec3> positions, std::vector<std::uint32_t> points)
      : positions_(positions), points_(std::move(points)), cuts_(points_.size()) {
    build(0, points_.size());
  }

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
      box.include(positions_[points_[i]]);
    }
    const glm::dvec3 size = box.max - box.min;
    const int axis = longest_axis(size);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t p, std::uint32_t q) {
      return positions_[p][axis] < positions_[q][axis];
    });
    cuts_[middle] = {.axis = axis, .at = positions_[points_[middle]][axis]};
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

  std::span<const glm::dvec3> positions_;
  std::vector<std::uint32_t> points_;
  std::vector<Cut> cuts_;  // before each point that is the first of an upper half
};

bool finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::vector<std::uint32_t> ends_of(std::span<const glm::dvec3> positions,
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
  std::erase_if(ends, [&](std::uint32_t end) { return !finite(positions[end]); });
  return ends;
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

struct OnEdge {
  double t = 0.0;
  double along = 0.0;  // by which they are sorted: exactly, if the vertex is on the edge exactly
  std::uint32_t vertex = 0;
};

EdgePart part_between(const OnEdge& from, const OnEdge& to, std::uint32_t half) {
  return {.low = std::min(from.vertex, to.vertex),
          .high = std::max(from.vertex, to.vertex),
          .half = half,
          .upwards = from.vertex < to.vertex,
          .from = from.t,
          .to = to.t};
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
  const std::vector<std::uint32_t> ends = ends_of(positions, welded, half_edges);
  Bounds box;
  for (const std::uint32_t end : ends) {
    box.include(positions[end]);
  }
  // Beyond what rounding makes of the distance.
  const double reach = std::max(tolerance, 1e-14 * greatest_coordinate(box));
  const PointTree tree(positions, ends);
  std::vector<std::vector<EdgePart>> of_parts(
      static_cast<std::size_t>(part_count(half_edges.size(), threads)));
  const std::size_t most = (most_on_edge + 1) * half_edges.size();
  parallel_parts(half_edges.size(), threads, [&](std::size_t begin, std::size_t end, int part) {
    std::vector<EdgePart>& out = of_parts[static_cast<std::size_t>(part)];
    std::vector<OnEdge> on_edge;
    for (std::size_t i = begin; i < end && out.size() <= most; ++i) {
      const OnEdge start{.t = 0.0, .along = 0.0, .vertex = half_edge_start(welded, half_edges[i])};
      const OnEdge stop{.t = 1.0, .along = 0.0, .vertex = half_edge_end(welded, half_edges[i])};
      const glm::dvec3& a = positions[start.vertex];
      const glm::dvec3& b = positions[stop.vertex];
      const glm::dvec3 along = b - a;
      const int axis = longest_axis(glm::abs(along));
      on_edge.assign(1, start);
      tree.near(a, b, reach, [&](std::uint32_t vertex) {
        const glm::dvec3 to = positions[vertex] - a;
        const double t = glm::dot(to, along) / glm::dot(along, along);
        const bool inside =
            vertex != start.vertex && vertex != stop.vertex &&
            (tolerance > 0.0 ? t > 0.0 && t < 1.0 && glm::length(to - t * along) <= tolerance
                             : exactly_between(positions[vertex], a, b));
        if (inside) {
          const double at = positions[vertex][axis];
          on_edge.push_back({.t = t, .along = along[axis] < 0.0 ? -at : at, .vertex = vertex});
        }
      });
      std::sort(on_edge.begin() + 1, on_edge.end(), [](const OnEdge& p, const OnEdge& q) {
        return std::tie(p.along, p.vertex) < std::tie(q.along, q.vertex);
      });
      on_edge.push_back(stop);
      for (std::size_t k = 1; k < on_edge.size(); ++k) {
        out.push_back(part_between(on_edge[k - 1], on_edge[k], half_edges[i]));
      }
    }
  });
  std::vector<EdgePart> all;
  for (const std::vector<EdgePart>& parts : of_parts) {
    all.insert(all.end(), parts.begin(), parts.end());
  }
  if (all.size() > most) {
    return {};
  }
  std::ranges::sort(
      all, {}, [](const EdgePart& part) { return std::tuple(part.low, part.high, part.half); });
  return all;
}

}  // namespace raycat
