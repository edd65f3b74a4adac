#include "geometry/edge_uses.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "threads/parallel.hpp"

namespace raycat {
namespace {

/// Calls `take(lower vertex, half-edge)` for the half-edges of some of the triangles.
template <typename Take>
void for_each_half_edge(std::span<const glm::uvec3> triangles, std::size_t begin, std::size_t end,
                        const Take& take) {
  for (std::size_t i = begin; i < end; ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[i][k];
      const std::uint32_t b = triangles[i][k == 2 ? 0 : k + 1];
      if (a != b) {
        take(std::min(a, b), static_cast<std::uint32_t>(3 * i) + static_cast<std::uint32_t>(k));
      }
    }
  }
}

}  // namespace

// A counting sort by the lower vertex, which keeps to the mesh's own order in memory (a hash of
// the edge would not). Each part of the triangles has places of its own among those of a vertex.
EdgeUses::EdgeUses(std::span<const glm::uvec3> triangles, std::size_t vertex_count, int threads)
    : triangles_(triangles), ends_(vertex_count) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 3;
  if (triangles.size() > most) {
    throw std::length_error(
        fmt::format("a mesh has at most {} triangles, but this has {}", most, triangles.size()));
  }
  // Those places are held for every vertex, so that parts may not be as many as threads.
  constexpr int most_parts = 4;
  threads = std::min(threads, most_parts);
  std::vector<std::vector<std::uint32_t>> places(
      static_cast<std::size_t>(part_count(triangles.size(), threads)));
  parallel_parts(triangles.size(), threads, [&](std::size_t begin, std::size_t end, int part) {
    std::vector<std::uint32_t>& count = places[static_cast<std::size_t>(part)];
    count.resize(vertex_count);
    for_each_half_edge(triangles, begin, end,
                       [&](std::uint32_t low, std::uint32_t) { ++count[low]; });
  });
  std::uint32_t sum = 0;
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    for (std::vector<std::uint32_t>& of_part : places) {
      sum += std::exchange(of_part[vertex], sum);
    }
    ends_[vertex] = sum;
  }
  half_edges_ = RawArray<std::uint32_t>(sum);
  parallel_parts(triangles.size(), threads, [&](std::size_t begin, std::size_t end, int part) {
    std::vector<std::uint32_t>& place = places[static_cast<std::size_t>(part)];
    for_each_half_edge(triangles, begin, end, [&](std::uint32_t low, std::uint32_t half) {
      half_edges_[place[low]++] = half;
    });
  });
}

}  // namespace raycat
