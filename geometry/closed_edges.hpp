#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/edge_parts.hpp"

namespace raycat {

/// Whether the edges of triangles are used as often one way as the other.
struct EdgeBalance {
  std::size_t bad = 0;        ///< edges that are not, nor are once they are cut
  std::uint32_t first = 0;    ///< the lowest half-edge of those
  bool is_open = false;       ///< is it the only one of its edge?
  std::vector<EdgePart> cut;  ///< half-edges that have to be cut at vertices on them, if any
};

/// Edges that are not balanced are cut at each other's ends, where these lie on them exactly; if
/// that balances all, none is bad.
EdgeBalance edge_balance(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> welded);

}  // namespace raycat
