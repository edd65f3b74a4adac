#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "antialias/square_region.hpp"

namespace raycat {

/// A pixel as `side` by `side` cells with the mean of each, for filters that weigh what is where.
class Patch {
 public:
  static constexpr int side = 8;

  /// A square at `at`, of this side, both in pixels, with these values at its corners, left to
  /// right, top to bottom, between which it is bilinear, and its mean, which makes up for the rest.
  void add(const glm::vec2& at, float size, const std::array<glm::vec4, 4>& corners,
           const glm::vec4& mean);

  /// A part of that square, which has this integral and changes by `along_x` and `along_y` a side
  /// of the square.
  void add(const glm::vec2& at, float size, const SquareRegion& region,
           const RegionIntegral& integral, const glm::vec4& along_x, const glm::vec4& along_y);

  /// The same everywhere, in addition.
  void shift(const glm::vec4& more);

  /// Row `row` of the cells.
  std::span<const glm::vec4> row(int row) const {
    return std::span(cells_).subspan(static_cast<std::size_t>(row) * side, side);
  }

 private:
  glm::vec4& cell(int x, int y) { return cells_[static_cast<std::size_t>(y * side + x)]; }

  std::array<glm::vec4, static_cast<std::size_t>(side) * side> cells_{};
};

}  // namespace raycat
