#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace raycat {

/// Sets of the numbers below `size`, each alone at first, that are joined two at a time, by any
/// number of threads at once.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::size_t size() const noexcept { return parent_.size(); }

  /// The lowest number of the set of `i`, once no thread is joining any more.
  std::uint32_t first(std::uint32_t i) noexcept {
    for (;;) {
      const std::uint32_t parent = at(i).load(std::memory_order_relaxed);
      if (parent == i) {
        return i;
      }
      const std::uint32_t above = at(parent).load(std::memory_order_relaxed);
      if (above == parent) {
        return parent;
      }
      at(i).store(above, std::memory_order_relaxed);  // only first members are ever linked anew
      i = above;
    }
  }

  void join(std::uint32_t a, std::uint32_t b) noexcept {
    for (;;) {
      a = first(a);
      b = first(b);
      if (a == b) {
        return;
      }
      std::uint32_t higher = std::max(a, b);
      if (at(higher).compare_exchange_strong(higher, std::min(a, b), std::memory_order_relaxed)) {
        return;
      }
    }
  }

 private:
  std::atomic_ref<std::uint32_t> at(std::uint32_t i) noexcept {
    return std::atomic_ref<std::uint32_t>(parent_[i]);
  }

  std::vector<std::uint32_t> parent_;  // no number is above its members
};

}  // namespace raycat
