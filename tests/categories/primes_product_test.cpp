#include "categories/primes_product.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "categories/exact_number.hpp"
#include "support/paper_trees.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

using Factors = std::vector<std::uint32_t>;

struct Product {
  CategoryWords words;
  std::uint64_t low_bits;  // the product modulo 2^64
  bool overflowed;
};

Product product_of(const PrimesProduct& method, const RayTree& tree) {
  Product product{.words = {99}};
  method.encode(tree, product.words);
  product.low_bits = std::uint64_t{product.words[0]} << 32 | product.words[1];
  product.overflowed = PrimesProduct::overflowed(product.words);
  return product;
}

Factors factors_of(const PrimesProduct& method, const RayTree& tree) {
  Factors factors{99};
  method.list_factors(tree, factors);
  return factors;
}

// A mirror chain of these surfaces, the first one hit first.
RayTree chain(const std::vector<std::uint32_t>& surfaces) {
  RayTree tree;
  HeapPosition position = root;
  for (const std::uint32_t surface : surfaces) {
    tree.insert(tree.begin(), {.position = position, .surface = SurfaceId{surface}});
    position = reflected(position);
  }
  return tree;
}

bool prime(std::uint32_t n) {
  for (std::uint32_t d = 2; d * d <= n; ++d) {
    if (n % d == 0) {
      return false;
    }
  }
  return n > 1;
}

TEST_CASE("the sieve finds the primes and no others", "[categories][primes]") {
  Factors expected;
  for (std::uint32_t n = 0; expected.size() < 1000; ++n) {
    if (prime(n)) {
      expected.push_back(n);
    }
  }
  for (std::size_t count = 0; count <= 1000; ++count) {
    REQUIRE((first_primes(count) ==
             Factors(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count))));
  }
  CHECK(first_primes(10'000).back() == 104'729);
  CHECK(first_primes(1'000'000).back() == 15'485'863);
}

TEST_CASE("the product of Fig. 2's symbols is theirs, lights having the least prime",
          "[categories][primes]") {
  const PrimesProduct method({.levels = 8, .lights = 1, .surfaces = 2});  // L = 2, A = 3, B = 5
  CHECK(factors_of(method, paper::fig2_a) == Factors{3, 2, 3, 2, 3});
  CHECK(factors_of(method, paper::fig2_b) == Factors{5, 2, 3, 2});
  CHECK(product_of(method, paper::fig2_a).words == CategoryWords{0, 108});
  CHECK(product_of(method, paper::fig2_b).words == CategoryWords{0, 60});
  CHECK(product_of(method, paper::fig2_c).words == CategoryWords{0, 1});
}

TEST_CASE("the trees of Fig. 3 have one product", "[categories][primes]") {
  const PrimesProduct method({.levels = 8, .surfaces = 2});
  CHECK(product_of(method, paper::fig3_a).words == CategoryWords{0, 6});
  CHECK(product_of(method, paper::fig3_b).words == CategoryWords{0, 6});
}

TEST_CASE("a product overflows at 2^64 and not below", "[categories][primes]") {
  const PrimesProduct powers({.levels = 64, .surfaces = 2});
  const Product below = product_of(powers, chain(std::vector<std::uint32_t>(63, 0)));
  CHECK(below.words == CategoryWords{0x80000000, 0});
  CHECK_FALSE(below.overflowed);
  const Product at = product_of(powers, chain(std::vector<std::uint32_t>(64, 0)));
  CHECK(at.low_bits == 0);
  CHECK(at.overflowed);

  // 2^64 - 1 = 3 5 17 257 641 65537 6700417, the greatest product that fits.
  const Factors primes = first_primes(500'000);
  std::vector<std::uint32_t> greatest;
  for (const std::uint32_t factor : {3u, 5u, 17u, 257u, 641u, 65'537u, 6'700'417u}) {
    const auto place = std::ranges::lower_bound(primes, factor);
    REQUIRE(*place == factor);
    greatest.push_back(static_cast<std::uint32_t>(place - primes.begin()));
  }
  const PrimesProduct many({.levels = 8, .surfaces = 500'000});
  CHECK(product_of(many, chain(greatest)).words == CategoryWords{0xffffffff, 0xffffffff});
  greatest.push_back(0);
  CHECK(product_of(many, chain(greatest)).words == CategoryWords{0xffffffff, 0xfffffffe, 1});
}

TEST_CASE("once over, a product stays over", "[categories][primes]") {
  const PrimesProduct method({.levels = 64, .surfaces = 2});
  for (std::size_t n = 0; n <= 64; ++n) {
    const RayTree tree = chain(std::vector<std::uint32_t>(n, 1));
    CHECK(product_of(method, tree).overflowed == (n > 40));  // 3^40 < 2^64 < 3^41
  }
}

TEST_CASE("a scene of too many surfaces for primes is refused", "[categories][primes]") {
  CHECK_THROWS_WITH(PrimesProduct({.levels = 8, .lights = 2, .surfaces = (1 << 24) + 1}),
                    "primes categories hold at most 16777216 surfaces, but 16777217 are needed");
}

TEST_CASE("the word holds the exact product modulo 2^64 and tells when it is not all",
          "[categories][primes]") {
  CHECK(rc::check([] {
    const int surfaces = *rc::gen::element(1, 10, 1000);
    const PrimesProduct method(
        {.levels = 8, .lights = 4, .surfaces = static_cast<std::uint64_t>(surfaces)});
    const RayTree tree = draw_tree({.levels = 8, .surfaces = surfaces, .lights = 4});
    const BigInteger exact = exact_product(factors_of(method, tree));
    const Product product = product_of(method, tree);
    RC_CLASSIFY(product.overflowed);
    RC_ASSERT(product.low_bits == static_cast<std::uint64_t>(exact & ~std::uint64_t{0}));
    RC_ASSERT(product.overflowed == (exact > ~std::uint64_t{0}));
    RC_ASSERT(product.words.size() == (product.overflowed ? 3u : 2u));
  }));
}

TEST_CASE("two trees have one product exactly when they have the same symbols",
          "[categories][primes]") {
  CHECK(rc::check([] {
    const Extent scene{.levels = 6, .lights = 2, .surfaces = 3};
    const PrimesProduct method(scene);
    const Symbols symbols(scene);
    const auto [a, b] = draw_pair({});
    const auto multiset = [&](const RayTree& tree) {
      std::multiset<std::uint32_t> all;
      symbols.list(tree, [&](std::uint32_t symbol) { all.insert(symbol); });
      return all;
    };
    const bool same = multiset(a) == multiset(b);
    RC_CLASSIFY(same && a != b, "collision");
    RC_ASSERT((exact_product(factors_of(method, a)) == exact_product(factors_of(method, b))) ==
              same);
  }));
}

TEST_CASE("small trees fall into as many products as multisets of symbols",
          "[categories][primes]") {
  const Extent scene{.levels = 3, .lights = 1, .surfaces = 2};
  const PrimesProduct method(scene);
  std::map<BigInteger, Factors> symbols_of;
  std::set<Factors> multisets;
  for (const RayTree& tree : all_trees({.levels = 3, .surfaces = 2, .lights = 1})) {
    Factors factors = factors_of(method, tree);
    const BigInteger product = exact_product(factors);
    std::ranges::sort(factors);
    multisets.insert(factors);
    const auto [known, added] = symbols_of.try_emplace(product, factors);
    REQUIRE(known->second == factors);
  }
  CHECK(symbols_of.size() == multisets.size());
  // Of n nodes, from 0 to 7, any number can be A and not B, and any number lit: (n + 1)^2.
  CHECK(multisets.size() == 204);
}

}  // namespace
}  // namespace raycat
