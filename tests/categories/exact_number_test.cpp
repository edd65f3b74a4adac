#include "categories/exact_number.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "categories/primes_product.hpp"

namespace raycat {
namespace {

using Factors = std::vector<std::uint32_t>;

unsigned bits(const BigInteger& number) { return msb(number) + 1; }

TEST_CASE("the products of Section 2.1.2 are as printed", "[categories][exact]") {
  CHECK(exact_product(Factors{2, 5, 2, 5, 2}) == 200);  // ALALA for A, B, L = 2, 3, 5
  CHECK(exact_product(Factors{3, 5, 2, 5}) == 150);     // BLAL
  CHECK(exact_product(Factors{}) == 1);
  // For A, L, B = 2, 3, 4, which are not coprime, the trees collide.
  CHECK(exact_product(Factors{2, 3, 2, 3, 2}) == 72);
  CHECK(exact_product(Factors{4, 3, 2, 3}) == 72);
}

TEST_CASE("the Gödel numbers of Section 2.1.3 are as printed", "[categories][exact]") {
  CHECK(godel_number(Factors{1, 3, 1, 3, 1}) == 1018710);  // ALALA for A, B, L = 1, 2, 3
  CHECK(godel_number(Factors{2, 3, 1, 3}) == 185220);      // BLAL
  CHECK(godel_number(Factors{}) == 1);
}

TEST_CASE("the product of the first 16 primes has 65 bits", "[categories][exact]") {
  const BigInteger product = exact_product(first_primes(16));
  CHECK(product == BigInteger("32589158477190044730"));
  CHECK(bits(product) == 65);
  CHECK(godel_number(Factors(16, 1)) == product);
}

TEST_CASE("products are exact far past a machine word", "[categories][exact]") {
  CHECK(exact_product(Factors(1000, 2)) == BigInteger(1) << 1000);
  CHECK(rc::check([](const std::vector<std::uint32_t>& factors) {
    BigInteger rest = exact_product(factors);
    for (const std::uint32_t factor : factors) {
      if (factor == 0) {
        RC_ASSERT(rest == 0);
        return;
      }
      RC_ASSERT(rest % factor == 0);
      rest /= factor;
    }
    RC_ASSERT(rest == 1);
  }));
}

TEST_CASE("the exponents of a Gödel number can be divided out again", "[categories][exact]") {
  CHECK(rc::check([] {
    const auto exponents = *rc::gen::container<Factors>(rc::gen::inRange<std::uint32_t>(0, 40));
    BigInteger rest = godel_number(exponents);
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      const std::uint32_t prime = first_primes(i + 1).back();
      std::uint32_t times = 0;
      for (; rest % prime == 0; rest /= prime) {
        ++times;
      }
      RC_ASSERT(times == exponents[i]);
    }
    RC_ASSERT(rest == 1);
  }));
}

TEST_CASE("the length of a Gödel number is known without working it out", "[categories][exact]") {
  CHECK(godel_bits(Factors{}) == 0.0);
  CHECK(godel_bits(Factors{100}) == Approx(100.0));
  CHECK(godel_bits(Factors{0, 4'000'000'000}) == Approx(4e9 * std::log2(3.0)));
  CHECK(rc::check([] {
    const auto exponents = *rc::gen::container<Factors>(rc::gen::inRange<std::uint32_t>(0, 40));
    const double length = bits(godel_number(exponents));  // log2 < length <= log2 + 1
    RC_ASSERT(godel_bits(exponents) < length + 1e-6);
    RC_ASSERT(godel_bits(exponents) > length - 1.0 - 1e-6);
  }));
}

}  // namespace
}  // namespace raycat
