#include "reference/polynomial_roots.hpp"

#include <cmath>

#include <catch2/catch.hpp>

namespace raycat::reference {
namespace {

TEST_CASE("roots are those that a polynomial is made of", "[reference][roots]") {
  const std::vector<Real> all{-3.5L, -0.125L, 0.1L, 0.1000001L};
  std::vector<Real> p{2.0L};
  for (const Real root : all) {  // times (t - root)
    p.push_back(0.0L);
    for (std::size_t i = p.size(); i-- > 0;) {
      p[i] = (i > 0 ? p[i - 1] : 0.0L) - root * p[i];
    }
  }
  const std::vector<Real> found = roots(p);
  REQUIRE(found.size() == all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(std::abs(found[i] - all[i]) < 1e-12L);
  }
}

TEST_CASE("where a polynomial only touches zero, or has no sign at all, there is no root",
          "[reference][roots]") {
  CHECK(roots({1.0L, -2.0L, 1.0L}).empty());  // (t - 1)^2
  CHECK(roots({1.0L, 0.0L, 1.0L}).empty());   // t^2 + 1
  CHECK(roots({3.0L}).empty());
  CHECK(roots({}).empty());
  CHECK(roots({-6.0L, 2.0L, 0.0L, 0.0L}) == std::vector<Real>{3.0L});
}

}  // namespace
}  // namespace raycat::reference
