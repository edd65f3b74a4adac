#include "categories/godel_number.hpp"

#include <map>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "categories/exact_number.hpp"
#include "categories/primes_product.hpp"
#include "support/paper_trees.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

const Extent scene{.levels = 6, .lights = 2, .surfaces = 3};

CategoryWords godel_of(const RayTree& tree) {
  CategoryWords words{99};
  GodelNumber(scene).encode(tree, words);
  return words;
}

CategoryWords string_of(const RayTree& tree) {
  CategoryWords words;
  IdString(scene).encode(tree, words);
  return words;
}

TEST_CASE("the Gödel numbers of Fig. 3 are 2^B 3^A and 2^A 3^B", "[categories][godel]") {
  // L1, L2, A, B, C = 1 to 5.
  CHECK(godel_number(godel_of(paper::fig3_a)) == 16 * 27);
  CHECK(godel_number(godel_of(paper::fig3_b)) == 8 * 81);
}

TEST_CASE("the trees of Fig. 4 have one Gödel number", "[categories][godel]") {
  CHECK(godel_number(godel_of(paper::fig4_a)) == 8 * 81 * 5 * 16807);  // ABLC: 2^3 3^4 5^1 7^5
  CHECK(godel_of(paper::fig4_a) == godel_of(paper::fig4_b));
}

TEST_CASE("the empty tree's Gödel number is 1", "[categories][godel]") {
  CHECK(godel_of({}).empty());
  CHECK(godel_number(godel_of({})) == 1);
}

TEST_CASE("Gödel numbers are equal when the strings are", "[categories][godel]") {
  CHECK(rc::check([] {
    const auto [a, b] = draw_pair({});
    const bool same = string_of(a) == string_of(b);
    RC_CLASSIFY(same && a != b, "collision");
    RC_ASSERT((godel_of(a) == godel_of(b)) == same);
    RC_ASSERT((godel_number(godel_of(a)) == godel_number(godel_of(b))) == same);
  }));
}

TEST_CASE("all small trees have as many Gödel numbers as strings", "[categories][godel]") {
  std::map<BigInteger, CategoryWords> string_by_number;
  for (const RayTree& tree : all_trees({.levels = 3, .surfaces = 1, .lights = 1})) {
    const auto [known, added] =
        string_by_number.try_emplace(godel_number(godel_of(tree)), string_of(tree));
    REQUIRE(known->second == string_of(tree));
  }
  // A string of n nodes is AL's and A's in any order: 2^n of each n from 0 to 7.
  CHECK(string_by_number.size() == 255);
}

TEST_CASE("a Gödel number overflows where it needs one bit more", "[categories][godel]") {
  for (const std::uint32_t size : {64u, 80u}) {
    CHECK_FALSE(GodelNumber::overflows({}, size));
    CHECK_FALSE(GodelNumber::overflows(CategoryWords{size - 1}, size));
    CHECK(GodelNumber::overflows(CategoryWords{size}, size));
    CHECK(GodelNumber::overflows(CategoryWords{0xffffffff}, size));
    CHECK(GodelNumber::overflows(CategoryWords(1'000'000, 1), size));
  }
  // 2 3 ... 47 has 60 bits and 2 3 ... 53, the 16 primes of Section 2.1.3, 65.
  CHECK_FALSE(GodelNumber::overflows(CategoryWords(15, 1), 64));
  CHECK(GodelNumber::overflows(CategoryWords(16, 1), 64));
  CHECK_FALSE(GodelNumber::overflows(CategoryWords(16, 1), 65));
  // 2^a 3 is at least 2^64 from a = 63 on, when 2^62 3 just fits.
  CHECK_FALSE(GodelNumber::overflows(CategoryWords{62, 1}, 64));
  CHECK(GodelNumber::overflows(CategoryWords{63, 1}, 64));
}

TEST_CASE("overflow is told as the exact number tells it", "[categories][godel]") {
  CHECK(rc::check([] {
    const auto size = *rc::gen::element<std::size_t>(64, 80);
    const auto exponents =
        *rc::gen::container<CategoryWords>(rc::gen::inRange<std::uint32_t>(1, 8));
    const bool over = godel_number(exponents) >= BigInteger(1) << size;
    RC_CLASSIFY(over);
    RC_ASSERT(GodelNumber::overflows(exponents, size) == over);
  }));
}

TEST_CASE("a scene past the limits is refused in the method's name", "[categories][godel]") {
  CHECK_THROWS_WITH(GodelNumber({.levels = 65, .lights = 1, .surfaces = 1}),
                    "godel categories hold at most 64 levels, but 65 are needed");
}

}  // namespace
}  // namespace raycat
