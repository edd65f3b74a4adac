// The methods that were there before: as many samples everywhere, or where a pixel is selected, or
// recursively where corners differ.

#include <algorithm>
#include <array>

#include "antialias/antialias.hpp"
#include "antialias/over_lattice.hpp"
#include "threads/row_progress.hpp"

namespace raycat {
namespace {

bool several_categories(const Corners& corners) {
  return std::ranges::any_of(corners, [&](const ColourSample* corner) {
    return corner->tree != corners[0]->tree || corner->textured;
  });
}

// The picture whose pixels are what `mean(pixel, corners, worker)` makes of their squares, or their
// corners' mean where it makes nothing.
template <typename Refine>
AntialiasedPicture over_lattice(Sampler& sampler, const AntialiasSettings& settings, int units,
                                const Refine& refine) {
  AntialiasedPicture out(settings.width, settings.height);
  SampleLattice lattice(sampler, settings.width, settings.height, units, settings.threads);
  lattice.trace_corners(settings.threads);
  std::atomic<std::uint64_t> refined = 0;
  RowProgress progress(settings.progress, settings.height);
  each_row_apart(settings.height, settings.threads, [&](int y, int worker) {
    for (int x = 0; x < settings.width; ++x) {
      const Square pixel = pixel_square(lattice, x, y);
      const Corners corners = pixel.corners(lattice, worker);
      const std::optional<glm::vec4> better = refine(lattice, pixel, corners, worker);
      refined += better ? 1 : 0;
      out.colour[out.index(x, y)] = better.value_or(mean_of(corners));
    }
    progress.row_done();
  });
  out.samples = lattice.counts();
  out.refined = refined;
  return out;
}

// The means of the corners of all the squares of one lattice unit in a pixel, which is to count a
// sample half on a side and a quarter at a corner.
glm::vec4 mean_of_units(SampleLattice& lattice, const Square& pixel, int worker) {
  glm::vec4 sum(0.0f);
  for (int j = 0; j <= pixel.size; ++j) {
    for (int i = 0; i <= pixel.size; ++i) {
      const bool side_x = i == 0 || i == pixel.size;
      const bool side_y = j == 0 || j == pixel.size;
      const float weight = (side_x ? 0.5f : 1.0f) * (side_y ? 0.5f : 1.0f);
      sum += weight * lattice.at(pixel.at + glm::ivec2(i, j), worker).colour;
    }
  }
  return 1.0f / static_cast<float>(pixel.size * pixel.size) * sum;
}

// Squares in quarters, as deep as `subdivides` and the lattice say. A picture has no deeper
// recursion than the lattice has levels, seven at most.
glm::vec4 subdivided(SampleLattice& lattice, const Square& square, const Subdivision& subdivides,
                     int worker) {
  const Corners corners = square.corners(lattice, worker);
  const double side = static_cast<double>(square.size) / lattice.units();
  if (square.size == 1 || !subdivides(corners, side * side)) {
    return mean_of(corners);
  }
  glm::vec4 sum(0.0f);
  const int half = square.size / 2;
  for (const glm::ivec2 quarter : {glm::ivec2(0, 0), {half, 0}, {0, half}, {half, half}}) {
    sum += subdivided(lattice, {.at = square.at + quarter, .size = half}, subdivides, worker);
  }
  return 0.25f * sum;
}

}  // namespace

AntialiasedPicture::AntialiasedPicture(int width_in, int height_in)
    : width(width_in), height(height_in), colour(index(0, height_in)) {}

std::vector<glm::vec3> AntialiasedPicture::without_alpha() const {
  return {colour.begin(), colour.end()};
}

AntialiasedPicture antialias_uniformly(Sampler& sampler, const AntialiasSettings& settings,
                                       int side) {
  AntialiasedPicture out(settings.width, settings.height);
  out.coverage.resize(settings.coverage ? out.colour.size() : 0);
  RowProgress progress(settings.progress, settings.height);
  FilteredPicture filtered(settings.filter, settings.width, settings.height, side);
  const float share = 1.0f / static_cast<float>(side * side);
  parallel_rows(settings.height, settings.threads, [&](int y, int worker) {
    std::vector<glm::vec4> cells;
    cells.reserve(static_cast<std::size_t>(settings.width * side * side));
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < settings.width * side; ++i) {
        const ColourSample sample =
            sampler.sample({(i + 0.5) / side, y + (j + 0.5) / side}, worker);
        cells.push_back(sample.colour);
        if (settings.coverage) {
          out.coverage[out.index(i / side, y)].push_back({.tree = sample.tree, .share = share});
        }
      }
    }
    filtered.set_row(y, cells);
    progress.row_done();
  });
  filtered.gather(settings.threads, out.colour);
  out.samples.colour =
      out.colour.size() * static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
  out.refined = side > 1 ? out.colour.size() : 0;
  return out;
}

Selection by_colour(float threshold) {
  return [threshold](const Corners& corners) { return farthest(corners) > threshold; };
}

Selection by_category() { return several_categories; }

AntialiasedPicture antialias_selected(Sampler& sampler, const AntialiasSettings& settings,
                                      const Selection& selection, int side) {
  return over_lattice(sampler, settings, side,
                      [&](SampleLattice& lattice, const Square& pixel, const Corners& corners,
                          int worker) -> std::optional<glm::vec4> {
                        return selection(corners)
                                   ? std::optional(mean_of_units(lattice, pixel, worker))
                                   : std::nullopt;
                      });
}

Subdivision subdivide_by_colour(float threshold, bool by_area) {
  return [threshold, by_area](const Corners& corners, double area) {
    return farthest(corners) * (by_area ? static_cast<float>(area) : 1.0f) > threshold;
  };
}

Subdivision subdivide_by_category() {
  return [](const Corners& corners, double /*area*/) { return several_categories(corners); };
}

AntialiasedPicture antialias_recursively(Sampler& sampler, const AntialiasSettings& settings,
                                         const Subdivision& subdivides, int depth) {
  return over_lattice(sampler, settings, 1 << depth,
                      [&](SampleLattice& lattice, const Square& pixel, const Corners& corners,
                          int worker) -> std::optional<glm::vec4> {
                        return depth > 0 && subdivides(corners, 1.0)
                                   ? std::optional(subdivided(lattice, pixel, subdivides, worker))
                                   : std::nullopt;
                      });
}

}  // namespace raycat
