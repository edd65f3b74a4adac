#include "antialias/sample_lattice.hpp"

#include <algorithm>
#include <bit>

#include "threads/parallel.hpp"

namespace raycat {
SampleLattice::SampleLattice(Sampler& sampler, int width, int height, int units, int threads)
    : sampler_(sampler),
      width_(width),
      height_(height),
      units_(units),
      shift_(std::has_single_bit(static_cast<unsigned>(units))
                 ? std::countr_zero(static_cast<unsigned>(units))
                 : -1),
      corners_(corner(0, height + 1)),
      buckets_(buckets_a_corner * corners_.size()),
      per_worker_(static_cast<std::size_t>(threads)) {}

void SampleLattice::trace_corners(int threads) {
  parallel_rows(height_ + 1, threads, [&](int row, int worker) {
    for (int column = 0; column <= width_; ++column) {
      corners_[corner(column, row)] = sampler_.sample(glm::dvec2(column, row), worker);
    }
    per_worker_[static_cast<std::size_t>(worker)].counts.colour +=
        static_cast<std::uint64_t>(width_) + 1;
  });
}

SampleLattice::Place SampleLattice::place(const Split& x, const Split& y) const {
  const std::size_t first = buckets_a_corner * corner(x.pixel, y.pixel);
  if (y.over == 0) {
    return {.bucket = first, .key = static_cast<std::uint32_t>(x.over)};
  }
  if (x.over == 0) {
    return {.bucket = first + 1, .key = static_cast<std::uint32_t>(y.over)};
  }
  return {.bucket = first + 2, .key = static_cast<std::uint32_t>(y.over * units_ + x.over)};
}

const ColourSample& SampleLattice::at(const glm::ivec2& point, int worker, bool* fresh) {
  const Split x = split(point.x);
  const Split y = split(point.y);
  if (x.over == 0 && y.over == 0) {
    return corners_[corner(x.pixel, y.pixel)];
  }
  const Place at = place(x, y);
  std::vector<Entry>& entries = bucket(at).entries;
  auto found = std::ranges::lower_bound(entries, at.key, {}, &Entry::place);
  if (found == entries.end() || found->place != at.key) {
    if (fresh != nullptr) {
      *fresh = true;
    }
    PerWorker& own = per_worker_[static_cast<std::size_t>(worker)];
    ++own.counts.colour;
    own.samples.push_back(sampler_.sample(in_pixels(point), worker));
    found = entries.insert(found, {.place = at.key, .sample = &own.samples.back()});
  }
  return *found->sample;
}

SampleLattice::Bucket& SampleLattice::bucket(const Place& at) {
  auto& bucket = buckets_[at.bucket];
  if (!bucket) {
    bucket = std::make_unique<Bucket>();
    constexpr std::size_t usual = 8;
    bucket->entries.reserve(usual);
  }
  return *bucket;
}

std::optional<TreeId> SampleLattice::side(const glm::ivec2& point, TreeId a, TreeId b, int worker) {
  if (const ColourSample* known = find(point)) {
    return known->tree == a || known->tree == b ? std::optional(known->tree) : std::nullopt;
  }
  const Place at = place(split(point.x), split(point.y));
  std::vector<Side>& sides = bucket(at).sides;
  const auto known = std::ranges::find_if(sides, [&](const Side& side) {
    return side.place == at.key && ((side.a == a && side.b == b) || (side.a == b && side.b == a));
  });
  if (known != sides.end()) {
    return known->is;
  }
  ++per_worker_[static_cast<std::size_t>(worker)].counts.category_only;
  const auto is = sampler_.side(in_pixels(point), a, b, worker);
  sides.push_back({.place = at.key, .a = a, .b = b, .is = is});
  return is;
}

const ColourSample* SampleLattice::find(const glm::ivec2& point) const {
  if (point.x < 0 || point.y < 0 || point.x > width_ * units_ || point.y > height_ * units_) {
    return nullptr;
  }
  const Split x = split(point.x);
  const Split y = split(point.y);
  if (x.over == 0 && y.over == 0) {
    return &corners_[corner(x.pixel, y.pixel)];
  }
  const Place at = place(x, y);
  const auto& bucket = buckets_[at.bucket];
  if (!bucket) {
    return nullptr;
  }
  const auto found = std::ranges::lower_bound(bucket->entries, at.key, {}, &Entry::place);
  return found != bucket->entries.end() && found->place == at.key ? found->sample : nullptr;
}

void SampleLattice::between(const glm::ivec2& start, const glm::ivec2& end,
                            std::vector<OnSide>& out) const {
  out.clear();
  const bool along_x = start.y == end.y;
  const glm::ivec2 inner =
      along_x ? glm::ivec2(start.x + 1, start.y) : glm::ivec2(start.x, start.y + 1);
  const Split x = split(inner.x);
  const Place first = place(x, split(inner.y));
  const auto& bucket = buckets_[first.bucket];
  if (!bucket) {
    return;
  }
  // Within a pixel, a column's places are a row of the lattice apart.
  const bool by_rows = !along_x && x.over != 0;
  const int length = along_x ? end.x - start.x : end.y - start.y;
  auto at = std::ranges::lower_bound(bucket->entries, first.key, {}, &Entry::place);
  for (; at != bucket->entries.end(); ++at) {
    const int distance = static_cast<int>(at->place - first.key);
    const Split steps = by_rows ? split(distance) : Split{.pixel = distance, .over = 0};
    if (steps.pixel >= length - 1) {
      break;
    }
    if (steps.over == 0) {
      out.push_back({.from_start = steps.pixel + 1, .sample = at->sample});
    }
  }
}

SampleCounts SampleLattice::counts() const {
  SampleCounts sum;
  for (const PerWorker& each : per_worker_) {
    sum += each.counts;
  }
  return sum;
}

}  // namespace raycat
