#pragma once

#include <optional>

#include <glm/vec4.hpp>

#include "antialias/sample_lattice.hpp"

namespace raycat {

/// Colour and alpha of a pixel, and what they may be off by.
struct PlainPixel {
  glm::vec4 mean{0.0f};
  float error = 0.0f;
};

/// Most pixels are plain: nothing has been sampled in them, all corners around are of one category,
/// and the quadratic that these tell is within `error`. Nothing if a pixel is not; then
/// `SquareAntialiaser` takes it, and whatever it makes of a plain pixel is this.
std::optional<PlainPixel> plain_pixel(const SampleLattice& lattice, int x, int y, float error);

}  // namespace raycat
