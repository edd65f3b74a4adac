#pragma once

#include <optional>

#include "antialias/adaptive_constants.hpp"
#include "antialias/antialias.hpp"

namespace raycat {

struct AdaptiveSettings {
  /// How far a pixel's colour may be off, as distances of linear colours are measured. What is less
  /// is left alone.
  float error = 0.01f;

  /// How many rays a pixel to spend in place of that, on the average: on what may be off most,
  /// first. The corners of pixels, a little more than one a pixel, are always traced.
  std::optional<double> budget;

  /// Do categories take part in what is decided? Without them colours alone do, for comparison.
  bool categories = true;

  /// To be changed by who measures them.
  AdaptiveConstants constants;
};

/// Our own method (docs/antialiasing.md): coverage instead of averages. Where two categories meet
/// in a square, its border is followed to where it crosses the sides, and each part has its own
/// colour; where all is of one category, its colour is integrated as the quadratic that the samples
/// around show. Squares that this fails for are subdivided in four, where it could make a
/// difference of `error` in the pixel.
AntialiasedPicture antialias_adaptively(Sampler& sampler, const AntialiasSettings& settings,
                                        const AdaptiveSettings& adaptive);

}  // namespace raycat
