#pragma once

#include <cstddef>

#include <glm/mat3x2.hpp>

namespace raycat {

/// Where on an image the points of a surface lie.
struct TexturePlace {
  std::size_t coordinates = 0;  ///< which of the mesh's sets of texture coordinates tells it
  glm::dmat3x2 transform{1.0};  ///< what brings them, as (u, v, 1), onto the image
};

}  // namespace raycat
