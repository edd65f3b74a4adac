#include "geometry/exactly_between.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <glm/gtc/type_precision.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

TEST_CASE("the middle of a segment lies on it, and a bit beside it does not",
          "[geometry][exactly_between]") {
  const glm::dvec3 a(-3.0, 1e-3, 5.0);
  const glm::dvec3 b(7.0, 3e-3, 1.0);
  const glm::dvec3 middle = 0.5 * (a + b);
  CHECK(exactly_between(middle, a, b));
  CHECK(exactly_between(middle, b, a));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double towards : {-10.0, 10.0}) {
      glm::dvec3 beside = middle;
      beside[axis] = std::nextafter(beside[axis], towards);
      CHECK_FALSE(exactly_between(beside, a, b));
    }
  }
}

TEST_CASE("the ends and what is beyond them are not between", "[geometry][exactly_between]") {
  const glm::dvec3 a(0.0);
  const glm::dvec3 b(2.0, 2.0, 2.0);
  CHECK_FALSE(exactly_between(a, a, b));
  CHECK_FALSE(exactly_between(b, a, b));
  CHECK_FALSE(exactly_between(glm::dvec3(3.0), a, b));
  CHECK_FALSE(exactly_between(glm::dvec3(-1.0), a, b));
  CHECK_FALSE(exactly_between(a, a, a));
  CHECK_FALSE(exactly_between({0.5, std::numeric_limits<double>::quiet_NaN(), 0.5}, a, b));
}

TEST_CASE("what is between agrees with whole numbers", "[geometry][exactly_between]") {
  CHECK(rc::check("far from the origin", [] {
    const auto coordinate = [] { return *rc::gen::inRange(-(1L << 40), 1L << 40); };
    const glm::i64vec3 a(coordinate(), coordinate(), coordinate());
    glm::i64vec3 step(*rc::gen::inRange(-9L, 10L), *rc::gen::inRange(-9L, 10L), 1L);
    step *= *rc::gen::inRange(1L, 1L << 20);
    const glm::i64vec3 b = a + 12L * step;
    const glm::i64vec3 nudge(*rc::gen::inRange(-1L, 2L), 0L, *rc::gen::inRange(-1L, 2L));
    const glm::i64vec3 p = a + *rc::gen::inRange(-2L, 15L) * step + nudge;
    const auto area = [](const glm::i64vec3& u, const glm::i64vec3& v, int x, int y) {
      return u[x] * v[y] - u[y] * v[x];
    };
    const glm::i64vec3 u = b - a;
    const glm::i64vec3 v = p - a;
    const bool in_a_row = area(u, v, 0, 1) == 0 && area(u, v, 1, 2) == 0 && area(u, v, 2, 0) == 0;
    const bool expected = in_a_row && v.z > 0 && v.z < u.z;
    RC_ASSERT(exactly_between(glm::dvec3(p), glm::dvec3(a), glm::dvec3(b)) == expected);
    RC_CLASSIFY(expected);
  }));
}

}  // namespace
}  // namespace raycat
