#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "categories/category.hpp"
#include "categories/symbols.hpp"

namespace raycat {

/// The first `count` primes, by the sieve of Eratosthenes (Section 2.1.2).
std::vector<std::uint32_t> first_primes(std::size_t count);

/// The primes product method (Section 2.1.2): symbol k is the k-th prime and a category the
/// product of its tree's symbols, in a machine word. Trees with the same symbols in another order
/// have the same product (Fig. 3).
class PrimesProduct {
 public:
  static constexpr Extent limits{.levels = 64, .lights = 64, .surfaces = 1 << 24};

  /// Throws `std::length_error`, naming the count, if `scene` is past `limits`.
  explicit PrimesProduct(const Extent& scene);

  /// Sets `words` to the product modulo 2^64, high word first, and if the product itself is
  /// larger, a third word that says so. The empty tree's product is 1.
  void encode(std::span<const RayNode> tree, CategoryWords& words) const;

  static bool overflowed(std::span<const std::uint32_t> words) noexcept {
    return words.size() == 3;
  }

  /// Sets `factors` to the primes that `encode` multiplies, in the order of the string.
  void list_factors(std::span<const RayNode> tree, std::vector<std::uint32_t>& factors) const;

 private:
  std::uint64_t prime(std::uint32_t symbol) const { return (*primes_)[symbol - 1]; }

  Symbols symbols_;
  std::shared_ptr<const std::vector<std::uint32_t>> primes_;
};

}  // namespace raycat
