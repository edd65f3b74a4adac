#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// The half-edges of triangles, brought together where they join the same two vertices.
/// Half-edge 3 i + k runs from corner k of triangle i to that triangle's next corner.
struct EdgeUses {
  std::vector<std::uint32_t> half_edges;  ///< those of one edge side by side, ascending
  std::vector<std::uint32_t> starts;      ///< where each edge's begin, and the end of all

  std::size_t size() const noexcept { return starts.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t edge) const noexcept {
    return {half_edges.data() + starts[edge], half_edges.data() + starts[edge + 1]};
  }
};

inline std::uint32_t half_edge_start(std::span<const glm::uvec3> triangles, std::uint32_t half) {
  return triangles[half / 3][static_cast<int>(half % 3)];
}

inline std::uint32_t half_edge_end(std::span<const glm::uvec3> triangles, std::uint32_t half) {
  return triangles[half / 3][static_cast<int>((half + 1) % 3)];
}

/// The edges between vertices numbered below `vertex_count`. A half-edge from a vertex to itself
/// is no edge's. Throws `std::length_error` if the half-edges cannot be numbered in 32 bits.
EdgeUses edge_uses(std::span<const glm::uvec3> triangles, std::size_t vertex_count);

}  // namespace raycat
