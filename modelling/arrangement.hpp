#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "modelling/exact.hpp"

namespace raycat {

/// Triangles cut along everything that they have in common with one another, so that what is left
/// has in common corners, whole edges and what lies in one plane. Of those in one plane each has
/// the others' edges as its own.
struct Arrangement {
  struct Piece {
    glm::uvec3 corners{0};  ///< indices into `points`, in the sense of the triangle
    std::uint32_t triangle = 0;
  };

  std::vector<Exact::Point_3> points;  ///< no two are equal
  std::vector<Piece> pieces;
};

/// Cuts the triangles marked in `wanted`, which have corners that are not in a row.
Arrangement arrange(std::span<const Exact::Point_3> points, std::span<const glm::uvec3> triangles,
                    std::span<const std::uint8_t> wanted);

}  // namespace raycat
