#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/raw_array.hpp"

namespace raycat {

inline std::uint32_t half_edge_start(std::span<const glm::uvec3> triangles, std::uint32_t half) {
  return triangles[half / 3][static_cast<int>(half % 3)];
}

inline std::uint32_t half_edge_end(std::span<const glm::uvec3> triangles, std::uint32_t half) {
  return triangles[half / 3][static_cast<int>((half + 1) % 3)];
}

/// The vertex of the triangle that is not on the half-edge.
inline std::uint32_t half_edge_apex(std::span<const glm::uvec3> triangles, std::uint32_t half) {
  return triangles[half / 3][static_cast<int>((half + 2) % 3)];
}

/// The half-edges of triangles, brought together where they join the same two vertices.
/// Half-edge 3 i + k runs from corner k of triangle i to that triangle's next corner; one from a
/// vertex to itself is no edge's.
class EdgeUses {
 public:
  /// Keeps a reference to the triangles, whose vertices are numbered below `vertex_count`. Throws
  /// `std::length_error` if the half-edges cannot be numbered in 32 bits.
  EdgeUses(std::span<const glm::uvec3> triangles, std::size_t vertex_count, int threads = 1);

  std::size_t vertices() const noexcept { return ends_.size(); }

  /// Calls `visit` with the half-edges of each edge, ascending, as `std::span<std::uint32_t>`:
  /// the edges whose lower vertex is from `begin` to `end` - 1, in the order of their lower and
  /// then their higher vertices.
  template <typename Visit>
  void for_each(std::size_t begin, std::size_t end, const Visit& visit) const;

  /// The same for all edges.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for_each(0, vertices(), visit);
  }

 private:
  std::span<const glm::uvec3> triangles_;
  RawArray<std::uint32_t> half_edges_;  // by lower vertex
  std::vector<std::uint32_t> ends_;     // of each vertex's half-edges
};

template <typename Visit>
void EdgeUses::for_each(std::size_t begin, std::size_t end, const Visit& visit) const {
  std::vector<std::uint64_t> uses;  // of one vertex: the higher vertex, then the half-edge
  std::vector<std::uint32_t> of_edge;
  std::uint32_t next = begin == 0 ? 0 : ends_[begin - 1];
  for (std::size_t vertex = begin; vertex < end; ++vertex) {
    uses.clear();
    for (; next < ends_[vertex]; ++next) {
      const std::uint32_t half = half_edges_[next];
      const std::uint64_t high =
          std::max(half_edge_start(triangles_, half), half_edge_end(triangles_, half));
      uses.push_back(high << 32U | half);
    }
    std::ranges::sort(uses);
    for (std::size_t i = 0; i < uses.size();) {
      const std::uint64_t high = uses[i] >> 32U;
      of_edge.clear();
      for (; i < uses.size() && uses[i] >> 32U == high; ++i) {
        of_edge.push_back(static_cast<std::uint32_t>(uses[i]));
      }
      visit(std::span<const std::uint32_t>(of_edge));
    }
  }
}

}  // namespace raycat
