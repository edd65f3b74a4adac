#include "geometry/coincident_twins.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "geometry/disjoint_sets.hpp"
#include "geometry/edge_uses.hpp"
#include "geometry/weld.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t no_number = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::vector<std::uint32_t> coincident_twins(std::span<const glm::dvec3> positions,
                                            std::span<const glm::uvec3> triangles, int threads) {
  const RawArray<glm::uvec3> vertices = welded(triangles, weld(positions, threads), threads);
  const EdgeUses edges(vertices, positions.size(), threads);
  std::vector<TriangleCopy> copies;
  std::mutex adding;
  parallel_parts(edges.vertices(), threads, [&](std::size_t begin, std::size_t end, int) {
    std::vector<TriangleCopy> of_part;
    edges.for_each(begin, end, [&](std::span<const std::uint32_t> uses) {
      add_copies(vertices, uses, of_part);
    });
    const std::lock_guard lock(adding);
    copies.insert(copies.end(), of_part.begin(), of_part.end());
  });
  return twins_of(copies, triangles.size());
}

std::vector<std::uint32_t> with_copies_joined(std::vector<std::uint32_t> faces,
                                              std::span<const std::uint32_t> twins) {
  if (twins.empty()) {
    return faces;
  }
  DisjointSets same(faces.empty() ? 0 : std::size_t{std::ranges::max(faces)} + 1);
  for (std::uint32_t i = 0; i < twins.size(); ++i) {
    if (twins[i] < i) {
      same.join(faces[i], faces[twins[i]]);
    }
  }
  std::vector<std::uint32_t> number(same.size(), no_number);
  std::uint32_t count = 0;
  for (std::uint32_t& face : faces) {
    std::uint32_t& of_face = number[same.first(face)];
    of_face = of_face == no_number ? count++ : of_face;
    face = of_face;
  }
  return faces;
}

void add_copies(std::span<const glm::uvec3> welded, std::span<const std::uint32_t> uses,
                std::vector<TriangleCopy>& copies) {
  if (uses.size() == 1 ||
      (uses.size() == 2 && half_edge_apex(welded, uses[0]) != half_edge_apex(welded, uses[1]))) {
    return;
  }
  const std::uint32_t high =
      std::max(half_edge_start(welded, uses.front()), half_edge_end(welded, uses.front()));
  thread_local std::vector<std::pair<std::uint32_t, std::uint32_t>> above;  // apex, half-edge
  above.clear();
  for (const std::uint32_t use : uses) {
    if (const std::uint32_t apex = half_edge_apex(welded, use); apex > high) {
      above.emplace_back(apex, use);
    }
  }
  std::ranges::sort(above);
  std::size_t first = 0;
  for (std::size_t i = 1; i < above.size(); ++i) {
    if (above[i].first != above[first].first) {
      first = i;
      continue;
    }
    const std::uint32_t kept = above[first].second;
    const std::uint32_t use = above[i].second;
    copies.push_back({.triangle = use / 3,
                      .kept = kept / 3,
                      .turned = half_edge_start(welded, use) != half_edge_start(welded, kept)});
  }
}

std::vector<std::uint32_t> twins_of(std::span<const TriangleCopy> copies, std::size_t triangles) {
  if (copies.empty()) {
    return {};
  }
  std::vector<std::uint32_t> twins(triangles, no_twin);
  for (const TriangleCopy& copy : copies) {
    twins[copy.triangle] = copy.kept;
    if (copy.turned) {
      twins[copy.kept] = std::min(twins[copy.kept], copy.triangle);
    }
  }
  return twins;
}

}  // namespace raycat
