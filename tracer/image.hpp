#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// Linear RGB, rows from the top; with alpha, which is associated, if it has any.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  ///< width * height
  std::vector<float> alpha;       ///< the same, or empty if the image is opaque

  Image(int width_in, int height_in, glm::vec3 fill = glm::vec3(0.0f))
      : width(width_in),
        height(height_in),
        pixels(static_cast<std::size_t>(width_in) * static_cast<std::size_t>(height_in), fill) {}

  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace raycat
