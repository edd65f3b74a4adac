#include "geometry/weld.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "geometry/disjoint_sets.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ bits >> 32U) * 0xd6e8feb86659fd93U;
  return bits ^ bits >> 32U;
}

std::uint64_t hash(const glm::dvec3& point) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
  return mixed(bits(point.x) + mixed(bits(point.y) + mixed(bits(point.z))));
}

bool finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// One of each set of equal points: whichever came first, which with threads is not always the
/// same one.
class PointTable {
 public:
  explicit PointTable(std::span<const glm::dvec3> positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), none) {}

  /// Calls `visit(i, j)` with each finite point from `begin` to `end` - 1 and the point of the
  /// table that equals it, which is itself if none does. The table is larger than caches, so that
  /// slots are asked for some points before they are looked at.
  template <typename Visit>
  void add(std::size_t begin, std::size_t end, const Visit& visit) {
    constexpr std::size_t ahead = 16;
    std::array<std::uint64_t, ahead> hashes{};
    for (std::size_t first = begin; first < end; first += ahead) {
      const std::size_t last = std::min(first + ahead, end);
      for (std::size_t i = first; i < last; ++i) {
        hashes[i - first] = hash(positions_[i]);
        __builtin_prefetch(&slots_[hashes[i - first] & mask()]);
      }
      for (std::size_t i = first; i < last; ++i) {
        if (finite(positions_[i])) {
          const auto number = static_cast<std::uint32_t>(i);
          visit(number, find_or_add(number, hashes[i - first]));
        }
      }
    }
  }

 private:
  std::size_t mask() const noexcept { return slots_.size() - 1; }

  // A slot holds a point and half of its hash, by which most others are told apart from it.
  std::uint32_t find_or_add(std::uint32_t i, std::uint64_t hash) {
    constexpr std::uint64_t tag = std::uint64_t{none} << 32U;
    const std::uint64_t own = (hash & tag) | i;
    for (std::size_t slot = hash & mask();; slot = (slot + 1) & mask()) {
      const std::atomic_ref<std::uint64_t> held(slots_[slot]);
      std::uint64_t there = held.load(std::memory_order_relaxed);
      if (there == none && held.compare_exchange_strong(there, own, std::memory_order_relaxed)) {
        return i;
      }
      const auto other = static_cast<std::uint32_t>(there);
      if ((there & tag) == (own & tag) && positions_[other] == positions_[i]) {
        return other;
      }
    }
  }

  std::span<const glm::dvec3> positions_;
  std::vector<std::uint64_t> slots_;
};

}  // namespace

std::vector<std::uint32_t> weld(std::span<const glm::dvec3> positions, int threads) {
  if (positions.size() >= none) {
    throw std::length_error(
        fmt::format("a mesh has at most {} vertices, but this has {}", none - 1, positions.size()));
  }
  PointTable table(positions);
  DisjointSets equal(positions.size());
  parallel_parts(positions.size(), threads, [&](std::size_t begin, std::size_t end, int) {
    table.add(begin, end, [&](std::uint32_t i, std::uint32_t same) { equal.join(i, same); });
  });
  std::vector<std::uint32_t> first(positions.size());
  parallel_each(positions.size(), threads,
                [&](std::size_t i) { first[i] = equal.first(static_cast<std::uint32_t>(i)); });
  return first;
}

RawArray<glm::uvec3> welded(std::span<const glm::uvec3> triangles,
                            std::span<const std::uint32_t> first, int threads) {
  RawArray<glm::uvec3> out(triangles.size());
  parallel_each(out.size(), threads, [&](std::size_t i) {
    out[i] = {first[triangles[i].x], first[triangles[i].y], first[triangles[i].z]};
  });
  return out;
}

}  // namespace raycat
