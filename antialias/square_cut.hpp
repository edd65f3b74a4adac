#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "antialias/border.hpp"
#include "antialias/corner_labels.hpp"
#include "antialias/pixel_samples.hpp"
#include "antialias/square_region.hpp"

namespace raycat {

/// The part of a square by which a border may miss its chord.
constexpr float border_bulge = 0.08f;

/// A square in two parts with a straight border between them.
struct SquareCut {
  struct Part {
    SquareRegion region;
    RegionIntegral integral;
    SurfaceFit surface;  ///< what the samples around show of it
  };
  std::array<Part, 2> parts;

  /// Where the border crosses the square's sides, in units of the square, and which; the first part
  /// is the one with the corners from the first side's end to the second's start.
  std::array<glm::vec2, 2> ends{};
  std::array<int, 2> sides{};
  float exact = 0.0f;  ///< how far the ends may be from where they are said to be
  float error = 0.0f;  ///< what the pixel may be off by because of this square

  glm::vec4 mean() const {
    return parts[0].integral.area * parts[0].integral.mean +
           parts[1].integral.area * parts[1].integral.mean;
  }
  Border border(const Corners& corners, const CornerLabels& labels) const;

  /// Which part a point of the square is in.
  std::size_t part_at(const glm::vec2& point) const;
};

/// Cuts a square whose corners are of two labels. Nothing if these lie crosswise, or if a sample is
/// against it.
std::optional<SquareCut> cut(PixelSamples& samples, const Square& square, const Corners& corners,
                             const CornerLabels& labels);

}  // namespace raycat
