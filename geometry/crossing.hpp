#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// One passage of a line through the surface of a solid shape.
struct Crossing {
  double t = 0.0;          ///< ray parameter, in units of the ray's direction
  glm::dvec3 normal{0.0};  ///< points out of the solid; of any positive length
  std::uint32_t face = 0;  ///< which face of the shape, from 0
  /// Which piece of its surface: a mesh's triangle; a capsule's side (0), lower (1) or upper ball
  /// (2); of other shapes the face.
  std::uint32_t piece = 0;
  bool entering = true;  ///< does the line go into the solid here as t grows?

  bool operator==(const Crossing&) const = default;
};

/// A buffer of crossings that the caller reuses from line to line.
using Crossings = std::vector<Crossing>;

}  // namespace raycat
