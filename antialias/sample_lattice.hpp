#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "antialias/sampler.hpp"

namespace raycat {

/// How many rays a picture has cost: whole ones, and those that only told two categories apart.
struct SampleCounts {
  std::uint64_t colour = 0;
  std::uint64_t category_only = 0;

  SampleCounts& operator+=(const SampleCounts& other) noexcept {
    colour += other.colour;
    category_only += other.category_only;
    return *this;
  }
};

/// The samples of a picture on a lattice of `units` by `units` points a pixel, from corner to
/// corner of the picture. Each is traced when it is first asked for, and kept: neighbours share
/// those on the borders between them.
///
/// Rows of pixels may be worked on at once as long as no two of them touch: a row's work traces
/// points of its own pixels and their borders, and looks at those of the rows beside it.
class SampleLattice {
 public:
  SampleLattice(Sampler& sampler, int width, int height, int units, int threads);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  int units() const noexcept { return units_; }

  /// Traces all corners of pixels. Before anything else.
  void trace_corners(int threads);

  /// The corners of pixels in a row of them, `width() + 1`.
  const ColourSample* corner_row(int row) const { return corners_.data() + corner(0, row); }

  /// Has anything been sampled within a pixel or on its borders, but for its corners?
  bool refined(int x, int y) const {
    const std::size_t here = buckets_a_corner * corner(x, y);
    const std::size_t below = buckets_a_corner * corner(x, y + 1);
    return buckets_[here] || buckets_[here + 1] || buckets_[here + 2] ||
           buckets_[here + buckets_a_corner + 1] || buckets_[below];
  }

  /// The sample at a point in lattice units, which is traced if it is not there; `fresh` is set if
  /// it was not.
  const ColourSample& at(const glm::ivec2& point, int worker, bool* fresh = nullptr);

  /// The sample if it is there; null if not, or if the point is outside the picture.
  const ColourSample* find(const glm::ivec2& point) const;

  /// A sample that is there, on the side of a square between two of its corners.
  struct OnSide {
    int from_start = 0;  ///< in lattice units
    const ColourSample* sample = nullptr;
  };

  /// Of which of two trees is the point, as `Sampler::side` tells? A sample that is there answers
  /// it, and else it is asked once.
  std::optional<TreeId> side(const glm::ivec2& point, TreeId a, TreeId b, int worker);

  /// Those strictly between two points of one row or one column of the lattice, at most a pixel
  /// apart.
  void between(const glm::ivec2& start, const glm::ivec2& end, std::vector<OnSide>& out) const;

  /// Rays traced so far. Not while others work.
  SampleCounts counts() const;

  Sampler& sampler() noexcept { return sampler_; }

 private:
  struct Side {
    std::uint32_t place = 0;
    TreeId a{};
    TreeId b{};
    std::optional<TreeId> is;
  };

  // The samples on one border of a pixel, or within it, in the order of their places there.
  struct Entry {
    std::uint32_t place = 0;
    const ColourSample* sample = nullptr;
  };
  struct Bucket {
    std::vector<Entry> entries;
    std::vector<Side> sides;
  };
  struct Place {
    std::size_t bucket = 0;
    std::uint32_t key = 0;
  };
  struct alignas(64) PerWorker {
    SampleCounts counts;
    std::deque<ColourSample> samples;  // which stay where they are
  };

  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
           static_cast<std::size_t>(column);
  }
  // A coordinate in pixels and what is over, without a division where units are a power of two:
  // that takes longer than to look a sample up.
  struct Split {
    int pixel = 0;
    int over = 0;
  };
  Split split(int coordinate) const noexcept {
    return shift_ >= 0 ? Split{.pixel = coordinate >> shift_, .over = coordinate & (units_ - 1)}
                       : Split{.pixel = coordinate / units_, .over = coordinate % units_};
  }
  Bucket& bucket(const Place& at);
  Place place(const Split& x, const Split& y) const;
  glm::dvec2 in_pixels(const glm::ivec2& point) const {
    return glm::dvec2(point) / static_cast<double>(units_);
  }

  Sampler& sampler_;
  int width_;
  int height_;
  int units_;
  int shift_;  // the power of two that units are, or -1
  std::vector<ColourSample> corners_;
  static constexpr std::size_t buckets_a_corner = 3;
  // Of each corner: the border to the right, the border below, and the pixel between them.
  std::vector<std::unique_ptr<Bucket>> buckets_;
  std::vector<PerWorker> per_worker_;
};

}  // namespace raycat
