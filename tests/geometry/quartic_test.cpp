#include "geometry/quartic.hpp"

#include <algorithm>
#include <cmath>

#include "tests/geometry/lines.hpp"

namespace raycat {
namespace {

using Values = std::vector<long double>;

// The polynomial with these roots.
Quartic with_roots(const Values& roots, long double leading) {
  Quartic result{leading};
  for (const long double root : roots) {
    for (std::size_t i = result.size(); i-- > 0;) {
      result[i] = (i > 0 ? result[i - 1] : 0.0L) - root * result[i];
    }
  }
  return result;
}

Values roots_of(const Quartic& quartic) {
  const Roots roots = real_roots(quartic);
  return {roots.begin(), roots.end()};
}

TEST_CASE("the roots of a product of four factors are found in order", "[geometry][quartic]") {
  const Values roots = roots_of(with_roots({3.0L, -2.0L, 0.5L, 0.0L}, -7.0L));
  REQUIRE(roots.size() == 4);
  CHECK(roots[0] == Approx(-2.0L).epsilon(1e-15));
  CHECK(roots[1] == Approx(0.0L).margin(1e-17));
  CHECK(roots[2] == Approx(0.5L).epsilon(1e-15));
  CHECK(roots[3] == Approx(3.0L).epsilon(1e-15));
}

TEST_CASE("polynomials of lower degree are solved too", "[geometry][quartic]") {
  CHECK(roots_of({1.0L, 0.0L, 0.0L, 0.0L, 0.0L}).empty());
  CHECK(roots_of({0.0L, 0.0L, 0.0L, 0.0L, 0.0L}).empty());
  CHECK(roots_of({-6.0L, 2.0L, 0.0L, 0.0L, 0.0L}) == Values{3.0L});
  CHECK(roots_of({-4.0L, 0.0L, 1.0L, 0.0L, 0.0L}) == Values{-2.0L, 2.0L});
  CHECK(roots_of({-8.0L, 0.0L, 0.0L, 1.0L, 0.0L}) == Values{2.0L});
  CHECK(roots_of({0.0L, 0.0L, 0.0L, 1.0L, 0.0L}) == Values{0.0L});
}

TEST_CASE("quartics without real roots have none", "[geometry][quartic]") {
  CHECK(roots_of({1.0L, 0.0L, 0.0L, 0.0L, 1.0L}).empty());
  CHECK(roots_of({4.0L, 0.0L, 5.0L, 0.0L, 1.0L}).empty());
}

TEST_CASE("a double root from above is no change of sign", "[geometry][quartic]") {
  CHECK(roots_of({0.0L, 0.0L, 1.0L, 0.0L, 1.0L}).empty());
  CHECK(roots_of({1.0L, 0.0L, -2.0L, 0.0L, 1.0L}).empty());
}

TEST_CASE("a triple root is found once", "[geometry][quartic]") {
  const Values roots = roots_of(with_roots({1.0L, 1.0L, 1.0L, -2.0L}, 1.0L));
  REQUIRE(roots.size() == 2);
  CHECK(roots[0] == Approx(-2.0L).epsilon(1e-15));
  CHECK(roots[1] == Approx(1.0L).epsilon(1e-5));
}

TEST_CASE("a known sign at a bound overrules the computed one", "[geometry][quartic]") {
  const Quartic touching{0.0L, 0.0L, 1.0L, 0.0L, 1.0L};
  const Roots roots =
      sign_changes(touching, {.x = -1.0L, .negative = false}, {.x = 0.0L, .negative = true});
  REQUIRE(roots.size() == 1);
  CHECK(std::abs(roots[0]) < 1e-9L);
}

TEST_CASE("roots of all magnitudes are found again", "[geometry][quartic]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 100; ++i) {
      const long double unit = dice.scale();
      Values roots;
      for (int k = 0; k < 4; ++k) {
        roots.push_back(unit * dice.between(-1.0, 1.0));
      }
      std::ranges::sort(roots);
      const Values found = roots_of(with_roots(roots, dice.scale()));
      long double gap = 2.0L * unit;
      for (std::size_t k = 1; k < 4; ++k) {
        gap = std::min(gap, roots[k] - roots[k - 1]);
      }
      if (gap < 1e-4L * unit) {
        continue;  // closer ones follow
      }
      RC_ASSERT(found.size() == 4U);
      for (std::size_t k = 0; k < 4; ++k) {
        RC_ASSERT(std::abs(found[k] - roots[k]) < 1e-10L * unit);
      }
    }
  }));
}

TEST_CASE("two roots 1e-6 apart are told apart and right to 1e-12", "[geometry][quartic]") {
  CHECK(rc::check([] {
    Dice dice;
    for (int i = 0; i < 100; ++i) {
      const long double first = dice.between(-0.5, 0.5);
      const Quartic quartic = with_roots({first, first + 1e-6L, -1.5L, 2.0L}, 1.0L);
      const Roots found = real_roots(quartic);
      RC_ASSERT(found.size() == 4U);
      RC_ASSERT(std::abs(found[1] - first) < 1e-12L);
      RC_ASSERT(std::abs(found[2] - first - 1e-6L) < 1e-12L);
    }
  }));
}

}  // namespace
}  // namespace raycat
