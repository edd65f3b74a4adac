#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "antialias/filter.hpp"
#include "antialias/sample_lattice.hpp"
#include "antialias/sampler.hpp"

namespace raycat {

/// How much of a pixel a tree covers.
struct TreeShare {
  TreeId tree{};
  float share = 0.0f;
};

/// Averages of a picture over its pixels, of samples as `ColourSample` has them.
struct AntialiasedPicture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec4> colour;  ///< width * height, rows from the top, alpha associated
  /// Which trees each pixel is of, with shares that sum to 1; only where it is asked for. A tree
  /// may be there more than once.
  std::vector<std::vector<TreeShare>> coverage;
  SampleCounts samples;
  std::uint64_t refined = 0;  ///< pixels that were sampled beyond their corners

  AntialiasedPicture(int width_in, int height_in);
  std::vector<glm::vec3> without_alpha() const;
  std::size_t index(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// What is the same for all methods. Results do not depend on the number of threads.
struct AntialiasSettings {
  int width = 512;
  int height = 512;
  int threads = 1;
  bool coverage =
      false;  ///< fill `AntialiasedPicture::coverage`, as uniform and adaptive methods can
  Filter filter = Filter::box;  ///< of the colours of these two; coverage is that of the box

  /// Called now and then with the rows done and their number, one call at a time.
  std::function<void(int done, int rows)> progress;
};

/// `side` by `side` samples in each pixel, at the middles of as many squares.
AntialiasedPicture antialias_uniformly(Sampler& sampler, const AntialiasSettings& settings,
                                       int side);

/// Which pixels deserve more than their corners: `corners` are in the order of a square's samples,
/// left to right, top to bottom.
using Selection = std::function<bool(const std::array<const ColourSample*, 4>& corners)>;

/// Corners whose colours are more than `threshold` apart (Section 4's simple threshold method).
Selection by_colour(float threshold);

/// Corners of several categories, or that met a textured surface (Sections 4 and 4.2).
Selection by_category();

/// Corners alone where a pixel is not selected; `side` by `side` squares of samples where it is,
/// whose borders neighbours share. `side` is at most 255.
AntialiasedPicture antialias_selected(Sampler& sampler, const AntialiasSettings& settings,
                                      const Selection& selection, int side);

/// Which squares of a pixel to subdivide in four: `area` is the square's, in pixels.
using Subdivision =
    std::function<bool(const std::array<const ColourSample*, 4>& corners, double area)>;

/// Corners that are more than `threshold` apart: Whitted's method. `by_area` weighs the difference
/// with the square's area, as it counts in the pixel.
Subdivision subdivide_by_colour(float threshold, bool by_area);

/// Corners of several categories, or that met a textured surface.
Subdivision subdivide_by_category();

/// Squares subdivided in four as long as `subdivides` says, at most `depth` times, from 0 to 6; the
/// mean of the corners is the square's.
AntialiasedPicture antialias_recursively(Sampler& sampler, const AntialiasSettings& settings,
                                         const Subdivision& subdivides, int depth);

}  // namespace raycat
