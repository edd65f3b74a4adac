#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "antialias/sampler.hpp"

namespace raycat {

/// Points of a lattice at which to look for something thin, by pixel.
class ThinPoints {
 public:
  ThinPoints() = default;

  /// Those that a sampler knows, on a lattice of `units` by `units` a pixel; what is outside the
  /// picture is left out, and of those in one pixel all but the first eight.
  ThinPoints(const Sampler& sampler, int width, int height, int units);

  std::span<const glm::ivec2> in(int x, int y) const;

 private:
  std::size_t width_ = 0;
  std::vector<std::uint32_t> begin_;  // of each pixel's points, and their end; none without points
  std::vector<glm::ivec2> points_;
};

}  // namespace raycat
