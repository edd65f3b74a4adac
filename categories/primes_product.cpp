#include "categories/primes_product.hpp"

#include <algorithm>
#include <cmath>

namespace raycat {
namespace {

// At least the n-th prime: p_n < n (ln n + ln ln n) from the sixth on (Rosser).
std::size_t bound_of_prime(std::size_t n) {
  const double x = std::max(6.0, static_cast<double>(n));
  return static_cast<std::size_t>(x * (std::log(x) + std::log(std::log(x)))) + 1;
}

}  // namespace

std::vector<std::uint32_t> first_primes(std::size_t count) {
  const std::size_t bound = bound_of_prime(count);
  std::vector<bool> composite(bound / 2 + 1);  // entry i is for 2i + 1
  std::vector<std::uint32_t> primes;
  primes.reserve(count);
  if (count > 0) {
    primes.push_back(2);
  }
  for (std::size_t i = 1; primes.size() < count; ++i) {
    if (composite[i]) {
      continue;
    }
    const std::size_t prime = 2 * i + 1;
    primes.push_back(static_cast<std::uint32_t>(prime));
    for (std::size_t multiple = prime * prime; multiple <= bound; multiple += 2 * prime) {
      composite[multiple / 2] = true;
    }
  }
  return primes;
}

PrimesProduct::PrimesProduct(const Extent& scene) : symbols_(scene) {
  require_within(scene, limits, "primes");
  primes_ = std::make_shared<const std::vector<std::uint32_t>>(
      first_primes(static_cast<std::size_t>(scene.lights + scene.surfaces)));
}

void PrimesProduct::encode(std::span<const RayNode> tree, CategoryWords& words) const {
  std::uint64_t product = 1;
  bool overflow = false;
  symbols_.list(tree, [&](std::uint32_t symbol) {
    overflow |= __builtin_mul_overflow(product, prime(symbol), &product);
  });
  words.assign({static_cast<std::uint32_t>(product >> 32), static_cast<std::uint32_t>(product)});
  if (overflow) {
    words.push_back(1);
  }
}

void PrimesProduct::list_factors(std::span<const RayNode> tree,
                                 std::vector<std::uint32_t>& factors) const {
  factors.clear();
  symbols_.list(tree, [&](std::uint32_t symbol) { factors.push_back((*primes_)[symbol - 1]); });
}

}  // namespace raycat
