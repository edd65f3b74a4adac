#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// A part of a half-edge, between two vertices on it that have none between them.
struct EdgePart {
  std::uint32_t low = 0;   ///< the lower-numbered vertex at its ends
  std::uint32_t high = 0;  ///< the other
  std::uint32_t half = 0;
  bool upwards = false;  ///< does the half-edge run from `low` to `high`?
  double from = 0.0;     ///< where the part begins, in parts of the half-edge's length
  double to = 1.0;       ///< and where it ends

  std::uint32_t from_vertex() const noexcept { return upwards ? low : high; }
};

/// Half-edges, numbered as `EdgeUses` does, cut at those of their ends that lie on the inside of
/// others, as where two edges of one triangle's size meet a longer one. A vertex lies on an edge if
/// it is no farther from it than `tolerance`; with one of 0 it has to lie on it exactly. Sorted by
/// `low`, `high` and `half`, so that parts of one place follow each other. Empty if no
/// edge is cut, or if there are more than 64 vertices an edge to cut at, as on no surface. The same
/// whatever `threads`.
std::vector<EdgePart> edge_parts(std::span<const glm::dvec3> positions,
                                 std::span<const glm::uvec3> welded,
                                 std::span<const std::uint32_t> half_edges, double tolerance,
                                 int threads = 1);

/// How far from an edge a vertex may be that is meant to lie on it: a millionth of the half
/// diagonal of the positions, or what rounding to float can have moved it if all are floats.
double edge_tolerance(std::span<const glm::dvec3> positions);

/// Calls `visit` with the parts of each place as a span.
template <typename Visit>
void for_each_place(std::span<const EdgePart> parts, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < parts.size(); begin = end) {
    while (end < parts.size() && parts[end].low == parts[begin].low &&
           parts[end].high == parts[begin].high) {
      ++end;
    }
    visit(parts.subspan(begin, end - begin));
  }
}

}  // namespace raycat
