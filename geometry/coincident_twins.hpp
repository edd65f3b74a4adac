#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// What a triangle without a twin has in place of one.
inline constexpr std::uint32_t no_twin = std::numeric_limits<std::uint32_t>::max();

/// Triangles on the same three points, which are one surface however often and whichever way round
/// it is stored. The lowest-numbered of them is kept; a twin is one that is wound the other way.
/// Entry i is
///
///     below i   for a copy: the kept triangle, wound either way
///     above i   for a kept one: its lowest-numbered twin
///     no_twin   for a kept one without: copies of it, if any, are wound as it is
///
/// so that i is kept if the entry is above i. Empty if all triangles lie on points of their own.
/// Points are the same if their coordinates are. Triangles with two corners at one point have no
/// copies. The same whatever `threads`.
std::vector<std::uint32_t> coincident_twins(std::span<const glm::dvec3> positions,
                                            std::span<const glm::uvec3> triangles, int threads = 1);

/// Faces, one a triangle, in which those of copies are joined: numbered anew, in the order of each
/// face's first triangle, unless there are no copies. `twins` is as above.
std::vector<std::uint32_t> with_copies_joined(std::vector<std::uint32_t> faces,
                                              std::span<const std::uint32_t> twins);

/// A triangle on the three points of one with a lower number.
struct TriangleCopy {
  std::uint32_t triangle = 0;
  std::uint32_t kept = 0;  ///< the lowest-numbered one
  bool turned = false;     ///< wound the other way?
};

/// Adds the copies among the triangles of an edge, given by their half-edges, ascending, as
/// `EdgeUses` does. Only those whose third vertex is above both of the edge, so that all edges
/// together have each copy once.
void add_copies(std::span<const glm::uvec3> welded, std::span<const std::uint32_t> uses,
                std::vector<TriangleCopy>& copies);

/// What `coincident_twins` makes of all copies of a mesh, in whichever order.
std::vector<std::uint32_t> twins_of(std::span<const TriangleCopy> copies, std::size_t triangles);

}  // namespace raycat
