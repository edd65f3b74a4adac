#include "geometry/edge_uses.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace raycat {

EdgeUses edge_uses(std::span<const glm::uvec3> triangles, std::size_t vertex_count) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 3;
  if (triangles.size() > most) {
    throw std::length_error(
        fmt::format("a mesh has at most {} triangles, but this has {}", most, triangles.size()));
  }
  const auto count = static_cast<std::uint32_t>(3 * triangles.size());
  const auto low_end = [&](std::uint32_t half) {
    return std::min(half_edge_start(triangles, half), half_edge_end(triangles, half));
  };
  const auto high_end = [&](std::uint32_t half) {
    return std::max(half_edge_start(triangles, half), half_edge_end(triangles, half));
  };

  // A counting sort by the lower vertex, which keeps to the mesh's own order in memory (a hash
  // of the edge would not), then a sort of the few edges that each vertex has.
  std::vector<std::uint32_t> next(vertex_count + 1, 0);
  for (std::uint32_t half = 0; half < count; ++half) {
    if (low_end(half) != high_end(half)) {
      ++next[low_end(half) + 1];
    }
  }
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    next[vertex + 1] += next[vertex];
  }
  EdgeUses result;
  result.half_edges.resize(next[vertex_count]);
  for (std::uint32_t half = 0; half < count; ++half) {
    if (low_end(half) != high_end(half)) {
      result.half_edges[next[low_end(half)]++] = half;
    }
  }
  result.starts.reserve(result.half_edges.size() / 2 + 1);
  std::vector<std::uint64_t> uses;  // of one vertex: the higher vertex, then the half-edge
  std::uint32_t begin = 0;
  for (std::size_t vertex = 0; vertex < vertex_count; ++vertex) {
    const std::uint32_t end = next[vertex];  // filling has moved it to the next vertex's begin
    uses.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t half = result.half_edges[i];
      uses.push_back(std::uint64_t{high_end(half)} << 32U | half);
    }
    std::ranges::sort(uses);
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint64_t use = uses[i - begin];
      if (i == begin || use >> 32U != uses[i - begin - 1] >> 32U) {
        result.starts.push_back(i);
      }
      result.half_edges[i] = static_cast<std::uint32_t>(use);
    }
    begin = end;
  }
  result.starts.push_back(begin);
  return result;
}

}  // namespace raycat
