#include "categories/godel_number.hpp"

#include <algorithm>

#include "categories/exact_number.hpp"
#include "categories/primes_product.hpp"

namespace raycat {
namespace {

const Extent& checked(const Extent& scene) {
  require_within(scene, GodelNumber::limits, "godel");
  return scene;
}

}  // namespace

GodelNumber::GodelNumber(const Extent& scene) : string_(checked(scene)) {}

bool GodelNumber::overflows(std::span<const std::uint32_t> exponents, std::size_t bits) {
  // Each factor is at least 2, so that no more than `bits` are multiplied.
  const std::vector<std::uint32_t> primes = first_primes(std::min(exponents.size(), bits));
  const BigInteger limit = BigInteger(1) << bits;
  BigInteger number = 1;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    for (std::uint32_t k = 0; k < exponents[i]; ++k) {
      number *= primes[i];
      if (number >= limit) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace raycat
