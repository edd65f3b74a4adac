#include "geometry/closed_edges.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/edge_uses.hpp"

namespace raycat {
namespace {

bool all_balanced(std::span<const EdgePart> parts) {
  bool balanced = !parts.empty();
  for_each_place(parts, [&](std::span<const EdgePart> of_place) {
    std::ptrdiff_t balance = 0;
    for (const EdgePart& part : of_place) {
      balance += part.upwards ? 1 : -1;
    }
    balanced = balanced && balance == 0;
  });
  return balanced;
}

}  // namespace

EdgeBalance edge_balance(std::span<const glm::dvec3> positions,
                         std::span<const glm::uvec3> welded) {
  EdgeBalance out;
  out.first = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> unbalanced;
  EdgeUses(welded, positions.size()).for_each([&](std::span<const std::uint32_t> uses) {
    std::ptrdiff_t balance = 0;
    for (const std::uint32_t half : uses) {
      balance += half_edge_start(welded, half) < half_edge_end(welded, half) ? 1 : -1;
    }
    if (balance != 0) {
      ++out.bad;
      unbalanced.insert(unbalanced.end(), uses.begin(), uses.end());
      if (uses.front() < out.first) {
        out.first = uses.front();
        out.is_open = uses.size() == 1;
      }
    }
  });
  if (out.bad > 0) {
    std::vector<EdgePart> parts = edge_parts(positions, welded, unbalanced, 0.0);
    if (all_balanced(parts)) {
      out.bad = 0;
      out.cut = std::move(parts);
    }
  }
  return out;
}

}  // namespace raycat
