#include "geometry/weld.hpp"

#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "geometry/disjoint_sets.hpp"
#include "geometry/parallel.hpp"

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

  /// The point of the table that equals point `i`, which is `i` itself if none has.
  std::uint32_t find_or_add(std::uint32_t i) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(positions_[i]) & mask;; slot = (slot + 1) & mask) {
      const std::atomic_ref<std::uint32_t> held(slots_[slot]);
      std::uint32_t there = held.load(std::memory_order_relaxed);
      if (there == none && held.compare_exchange_strong(there, i, std::memory_order_relaxed)) {
        return i;
      }
      if (positions_[there] == positions_[i]) {
        return there;
      }
    }
  }

 private:
  std::span<const glm::dvec3> positions_;
  std::vector<std::uint32_t> slots_;
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
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      if (finite(positions[i])) {
        equal.join(i, table.find_or_add(i));
      }
    }
  });
  std::vector<std::uint32_t> first(positions.size());
  parallel_parts(positions.size(), threads, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
      first[i] = equal.first(i);
    }
  });
  return first;
}

}  // namespace raycat
