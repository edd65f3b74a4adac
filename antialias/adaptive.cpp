#include "antialias/adaptive.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include "antialias/plain_pixel.hpp"
#include "antialias/square_antialiaser.hpp"
#include "threads/row_progress.hpp"

namespace raycat {
namespace {

constexpr int units = 1024;

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

class AdaptivePicture {
 public:
  AdaptivePicture(Sampler& sampler, const AntialiasSettings& settings,
                  const AdaptiveSettings& adaptive)
      : settings_(settings),
        adaptive_(adaptive),
        out_(settings.width, settings.height),
        lattice_(sampler, settings.width, settings.height, units, settings.threads),
        thin_(sampler, settings.width, settings.height, units),
        pending_(out_.colour.size()),
        pixels_(out_.colour.size()),
        borders_(static_cast<std::size_t>(settings.height)),
        noticed_(static_cast<std::size_t>(settings.threads)) {
    out_.coverage.resize(settings.coverage ? out_.colour.size() : 0);
    lattice_.trace_corners(settings.threads);
  }

  AntialiasedPicture antialiased() {
    if (adaptive_.budget) {
      spend(*adaptive_.budget);
    } else {
      antialias_all(adaptive_.error);
    }
    if (settings_.filter == Filter::box) {
      bend_borders();
    } else {
      filter();
    }
    out_.samples = lattice_.counts();
    out_.refined = static_cast<std::uint64_t>(std::ranges::count(pixels_, true, &Pixel::refined));
    return std::move(out_);
  }

 private:
  struct Pixel {
    float allowed = 0.0f;  // the error that it was antialiased with
    float error = 0.0f;    // what it may be off by
    bool refined = false;
  };

  void antialias_all(float error) {
    std::vector<std::size_t> all(pixels_.size());
    for (std::size_t pixel = 0; pixel < all.size(); ++pixel) {
      all[pixel] = pixel;
      pixels_[pixel].allowed = error;
    }
    RowProgress progress(settings_.progress, settings_.height);
    settle(std::move(all), [&] { progress.row_done(); });
  }

  // Lets the error that is allowed go down from where nothing is sampled, and at each step
  // antialiases the pixels that may be off by more, the worst first, as long as there is something
  // to spend.
  void spend(double rays_per_pixel) {
    constexpr float coarsest = 1.0f;
    constexpr float finest = 1e-5f;
    constexpr float step = 0.8f;
    constexpr std::uint64_t most_of_a_pixel = 320;  // that is subdivided as often as may be
    const auto budget = static_cast<std::uint64_t>(
        std::floor(rays_per_pixel * static_cast<double>(pixels_.size())));
    const auto spent = [&] {
      const SampleCounts counts = lattice_.counts();
      return counts.colour + counts.category_only;
    };
    antialias_all(coarsest);
    const std::uint64_t at_first = spent();
    std::vector<std::size_t> worst;
    for (float error = coarsest; error > finest; error *= step) {
      worst.clear();
      for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
        if (pixels_[pixel].error > error) {
          worst.push_back(pixel);
        }
      }
      std::ranges::stable_sort(worst, std::ranges::greater(),
                               [&](std::size_t pixel) { return pixels_[pixel].error; });
      for (auto next = worst.begin(); next != worst.end();) {
        const std::uint64_t so_far = spent();
        const std::uint64_t several = budget > so_far ? (budget - so_far) / most_of_a_pixel : 0;
        if (several == 0) {
          return;
        }
        const auto end = next + std::min(static_cast<std::ptrdiff_t>(several), worst.end() - next);
        std::vector<std::size_t> now(next, end);
        for (const std::size_t pixel : now) {
          pixels_[pixel].allowed = error;
        }
        std::ranges::sort(now);
        settle(std::move(now), [] {});
        next = end;
        if (settings_.progress) {
          settings_.progress(static_cast<int>(100 * (spent() - at_first) / (budget - at_first)),
                             100);
        }
      }
    }
  }

  // Antialiases pixels, in ascending order, and those again to which neighbours have put samples on
  // the border between them.
  template <typename RowDone>
  void settle(std::vector<std::size_t> now, const RowDone& row_done) {
    constexpr int most_rounds = 8;
    for (const std::size_t pixel : now) {
      pending_[pixel] = 1;
    }
    for (int round = 0; round < most_rounds && !now.empty(); ++round) {
      antialias_rows(now, [&] {
        if (round == 0) {
          row_done();
        }
      });
      now.clear();
      for (std::vector<std::size_t>& noticed : noticed_) {
        std::ranges::copy_if(noticed, std::back_inserter(now),
                             [&](std::size_t pixel) { return pending_[pixel] != 0; });
        noticed.clear();
      }
      std::ranges::sort(now);
      now.erase(std::unique(now.begin(), now.end()), now.end());
    }
    for (const std::size_t pixel : now) {
      pending_[pixel] = 0;
    }
  }

  template <typename RowDone>
  void antialias_rows(const std::vector<std::size_t>& now, const RowDone& row_done) {
    const auto width = static_cast<std::size_t>(settings_.width);
    std::array<std::vector<std::span<const std::size_t>>, 2> rows;  // even and odd ones
    for (auto begin = now.begin(); begin != now.end();) {
      const std::size_t y = *begin / width;
      const auto end = std::lower_bound(begin, now.end(), (y + 1) * width);
      rows[y % 2].emplace_back(begin, end);
      begin = end;
    }
    constexpr std::size_t few = 64;  // that are not worth a thread
    const int threads = std::min(settings_.threads, static_cast<int>(now.size() / few) + 1);
    for (const auto& apart : rows) {
      parallel_rows(static_cast<int>(apart.size()), threads, [&](int i, int worker) {
        SquareAntialiaser antialiaser(lattice_, thin_, adaptive_, settings_.coverage, worker);
        for (const std::size_t pixel : apart[static_cast<std::size_t>(i)]) {
          if (pending_[pixel].load(std::memory_order_relaxed) != 0) {
            pending_[pixel].store(0, std::memory_order_relaxed);  // only this row's work reads it
            antialias_pixel(antialiaser, pixel, worker);
          }
        }
        row_done();
      });
    }
  }

  void antialias_pixel(SquareAntialiaser& antialiaser, std::size_t number, int worker) {
    Pixel& pixel = pixels_[number];
    const auto width = static_cast<std::size_t>(settings_.width);
    const auto x = static_cast<int>(number % width);
    const auto y = static_cast<int>(number / width);
    if (adaptive_.categories && thin_.in(x, y).empty()) {
      if (const auto plain = plain_pixel(lattice_, x, y, pixel.allowed)) {
        out_.colour[number] = plain->mean;
        pixel.error = plain->error;
        borders_[static_cast<std::size_t>(y)].set(x, std::nullopt);
        if (settings_.coverage) {
          const ColourSample& corner = lattice_.corner_row(y)[x];
          out_.coverage[number] = {{.tree = corner.tree, .share = 1.0f}};
        }
        return;
      }
    }
    SquareAntialiaser::Result& result = antialiaser.antialias(x, y, pixel.allowed, nullptr);
    out_.colour[number] = result.mean;
    pixel.error = result.error;
    pixel.refined = pixel.refined || result.refined;
    borders_[static_cast<std::size_t>(y)].set(x, result.cut);
    if (settings_.coverage) {
      out_.coverage[number] = std::move(result.shares);
    }
    const auto& [left, right, above, below] = result.borders;
    for (const auto& [is, column, row] :
         {std::tuple(left, x - 1, y), {right, x + 1, y}, {above, x, y - 1}, {below, x, y + 1}}) {
      if (is && column >= 0 && column < settings_.width && row >= 0 && row < settings_.height) {
        pending_[out_.index(column, row)] = 1;
        noticed_[static_cast<std::size_t>(worker)].push_back(out_.index(column, row));
      }
    }
  }

  void bend_borders() {
    parallel_rows(settings_.height, settings_.threads, [&](int y, int /*worker*/) {
      for (const int x : borders_[static_cast<std::size_t>(y)].columns()) {
        const std::size_t pixel = out_.index(x, y);
        out_.colour[pixel] = glm::clamp(out_.colour[pixel] + bent(x, y), 0.0f, 1.0f);
      }
    });
  }

  // What a border's bend adds to its pixel.
  glm::vec4 bent(int x, int y) {
    const Border& border = *borders_[static_cast<std::size_t>(y)].find(x);
    const float moved = bend(borders_, x, y);
    if (settings_.coverage) {
      move(out_.coverage[out_.index(x, y)], border, moved);
    }
    return moved * (border.right - border.left);
  }

  // Antialiases all pixels once more, for what is where in them.
  void filter() {
    FilteredPicture filtered(settings_.filter, settings_.width, settings_.height, Patch::side);
    each_row_apart(settings_.height, settings_.threads, [&](int y, int worker) {
      SquareAntialiaser antialiaser(lattice_, thin_, adaptive_, false, worker);
      const std::size_t line = static_cast<std::size_t>(settings_.width) * Patch::side;
      std::vector<glm::vec4> cells(line * Patch::side);
      for (int x = 0; x < settings_.width; ++x) {
        Patch patch;
        antialiaser.antialias(x, y, pixels_[out_.index(x, y)].allowed, &patch);
        if (borders_[static_cast<std::size_t>(y)].find(x) != nullptr) {
          patch.shift(bent(x, y));
        }
        for (int j = 0; j < Patch::side; ++j) {
          std::ranges::copy(patch.row(j),
                            cells.begin() + static_cast<std::ptrdiff_t>(
                                                static_cast<std::size_t>(j) * line +
                                                static_cast<std::size_t>(x) * Patch::side));
        }
      }
      filtered.set_row(y, cells);
    });
    filtered.gather(settings_.threads, out_.colour);
  }

  const AntialiasSettings& settings_;
  const AdaptiveSettings& adaptive_;
  AntialiasedPicture out_;
  SampleLattice lattice_;
  ThinPoints thin_;
  std::vector<std::atomic<std::uint8_t>> pending_;  // is a pixel to be antialiased, maybe again?
  std::vector<Pixel> pixels_;
  std::vector<BorderRow> borders_;
  std::vector<std::vector<std::size_t>> noticed_;  // by worker: pixels that got something to see
};

}  // namespace

AntialiasedPicture antialias_adaptively(Sampler& sampler, const AntialiasSettings& settings,
                                        const AdaptiveSettings& adaptive) {
  return AdaptivePicture(sampler, settings, adaptive).antialiased();
}

}  // namespace raycat
