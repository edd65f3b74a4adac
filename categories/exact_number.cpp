#include "categories/exact_number.hpp"

#include <cmath>
#include <vector>

#include "categories/primes_product.hpp"

namespace raycat {

BigInteger exact_product(std::span<const std::uint32_t> factors) {
  BigInteger product = 1;
  for (const std::uint32_t factor : factors) {
    product *= factor;
  }
  return product;
}

BigInteger godel_number(std::span<const std::uint32_t> exponents) {
  const std::vector<std::uint32_t> primes = first_primes(exponents.size());
  BigInteger number = 1;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    number *= boost::multiprecision::pow(BigInteger(primes[i]), exponents[i]);
  }
  return number;
}

double godel_bits(std::span<const std::uint32_t> exponents) {
  const std::vector<std::uint32_t> primes = first_primes(exponents.size());
  double bits = 0.0;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    bits += exponents[i] * std::log2(primes[i]);
  }
  return bits;
}

}  // namespace raycat
