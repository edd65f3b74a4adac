#include "antialias/adaptive.hpp"

#include <algorithm>
#include <atomic>
#include <vector>

#include <glm/common.hpp>

#include "antialias/square_smoother.hpp"
#include "tracer/row_progress.hpp"

namespace raycat {
namespace {

constexpr int units = 1024;
constexpr int most_rounds = 8;

// What a border has on its right because it bends, it does not have on its left.
void move(std::vector<TreeShare>& shares, const Border& border, float share) {
  const auto add = [&](TreeId tree, float more) {
    const auto found = std::ranges::find(shares, tree, &TreeShare::tree);
    if (found != shares.end()) {
      found->share += more;
    }
  };
  add(border.left_tree, -share);
  add(border.right_tree, share);
}

}  // namespace

SmoothPicture smooth_adaptively(Sampler& sampler, const SmoothSettings& settings,
                                const AdaptiveSettings& adaptive) {
  SmoothPicture out(settings.width, settings.height);
  out.coverage.resize(settings.coverage ? out.colour.size() : 0);
  SampleLattice lattice(sampler, settings.width, settings.height, units, settings.threads);
  lattice.trace_corners(settings.threads);
  // Pixels that are to be smoothed, at first or again, since a neighbour has put samples on the
  // border between them.
  std::vector<std::atomic<std::uint8_t>> pending(out.colour.size());
  std::ranges::fill(pending, std::uint8_t{1});
  std::vector<std::uint8_t> refined(out.colour.size());
  std::vector<BorderRow> borders(static_cast<std::size_t>(settings.height));
  RowProgress progress(settings.progress, settings.height);
  for (int round = 0; round < most_rounds; ++round) {
    std::atomic<bool> again = false;
    each_row_apart(settings.height, settings.threads, [&](int y, int worker) {
      SquareSmoother smoother(lattice, adaptive, settings.coverage, worker);
      const auto notify = [&](int x, int row) {
        if (x >= 0 && x < out.width && row >= 0 && row < out.height) {
          pending[out.index(x, row)] = 1;
          again = true;
        }
      };
      for (int x = 0; x < out.width; ++x) {
        const std::size_t pixel = out.index(x, y);
        if (pending[pixel].exchange(0) == 0) {
          continue;
        }
        const SquareSmoother::Result result = smoother.smooth(x, y);
        out.colour[pixel] = glm::vec3(result.mean);
        out.alpha[pixel] = result.mean.a;
        refined[pixel] |= result.refined ? 1 : 0;
        borders[static_cast<std::size_t>(y)].set(x, result.cut);
        if (settings.coverage) {
          out.coverage[pixel] = result.shares;
        }
        const auto& [left, right, above, below] = result.borders;
        for (const auto& [is, column, row] : {std::tuple(left, x - 1, y),
                                              {right, x + 1, y},
                                              {above, x, y - 1},
                                              {below, x, y + 1}}) {
          if (is) {
            notify(column, row);
          }
        }
      }
      if (round == 0) {
        progress.row_done();
      }
    });
    if (!again) {
      break;
    }
  }
  parallel_rows(settings.height, settings.threads, [&](int y, int /*worker*/) {
    const BorderRow& row = borders[static_cast<std::size_t>(y)];
    for (const int x : row.columns()) {
      const Border& border = *row.find(x);
      const float moved = bend(borders, x, y);
      const glm::vec4 more = moved * (border.right - border.left);
      const std::size_t pixel = out.index(x, y);
      if (settings.coverage) {
        move(out.coverage[pixel], border, moved);
      }
      out.colour[pixel] = glm::clamp(out.colour[pixel] + glm::vec3(more), 0.0f, 1.0f);
      out.alpha[pixel] = glm::clamp(out.alpha[pixel] + more.a, 0.0f, 1.0f);
    }
  });
  out.samples = lattice.counts();
  out.refined = static_cast<std::uint64_t>(std::ranges::count(refined, 1));
  return out;
}

}  // namespace raycat
