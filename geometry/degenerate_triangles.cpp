#include "geometry/degenerate_triangles.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace raycat {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::vector<std::uint32_t> settled_by_vertex(const std::vector<bool>& is_settled,
                                             std::span<const glm::uvec3> welded,
                                             std::size_t vertices) {
  std::vector<std::uint32_t> triangle_at(vertices, none);
  for (std::uint32_t i = 0; i < welded.size(); ++i) {
    for (int k = 0; is_settled[i] && k < 3; ++k) {
      triangle_at[welded[i][k]] = std::min(triangle_at[welded[i][k]], i);
    }
  }
  return triangle_at;
}

void spread_through_vertices(const std::vector<bool>& is_settled,
                             std::span<const glm::uvec3> welded, std::size_t vertices,
                             DisjointSets& faces) {
  std::vector<std::uint32_t> triangle_at;  // by vertex; made if ever needed
  for (std::uint32_t i = 0; i < welded.size(); ++i) {
    if (is_settled[i]) {
      continue;
    }
    if (triangle_at.empty()) {
      triangle_at = settled_by_vertex(is_settled, welded, vertices);
    }
    for (int k = 0; k < 3; ++k) {
      if (triangle_at[welded[i][k]] != none) {
        faces.join(i, triangle_at[welded[i][k]]);
        break;
      }
    }
  }
}

}  // namespace

void spread_over(const std::vector<bool>& degenerate, std::span<const glm::uvec3> welded,
                 const EdgeUses& edges, DisjointSets& faces) {
  std::vector<std::uint32_t> settled;
  for (std::uint32_t i = 0; i < welded.size(); ++i) {
    if (!degenerate[i]) {
      settled.push_back(i);
    }
  }
  // The next half-edge of the same edge, round and round; none of one that is no edge's.
  std::vector<std::uint32_t> round(3 * welded.size(), none);
  edges.for_each([&](std::span<const std::uint32_t> uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      round[uses[i]] = uses[(i + 1) % uses.size()];
    }
  });
  std::vector<bool> is_settled = degenerate;
  is_settled.flip();
  for (std::size_t next = 0; next < settled.size(); ++next) {
    const std::uint32_t triangle = settled[next];
    for (std::uint32_t half = 3 * triangle; half < 3 * triangle + 3; ++half) {
      // An edge is gone round once.
      for (std::uint32_t use = std::exchange(round[half], none); use != none;
           use = std::exchange(round[use], none)) {
        if (!is_settled[use / 3]) {
          is_settled[use / 3] = true;
          settled.push_back(use / 3);
          faces.join(triangle, use / 3);
        }
      }
    }
  }
  spread_through_vertices(is_settled, welded, edges.vertices(), faces);
}

}  // namespace raycat
