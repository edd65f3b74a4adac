#include "tracer/scrambled_points.hpp"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("every box of one part in 2^k holds one of 2^k points", "[tracer][points]") {
  const auto seed = static_cast<std::uint64_t>(GENERATE(0, 1, 977));
  const ScrambledPoints points(seed);
  constexpr int k = 10;
  constexpr std::uint32_t count = 1U << k;
  const auto first = static_cast<std::uint32_t>(GENERATE(0, 1, 5)) * count;
  for (int wide = 0; wide <= k; ++wide) {  // 2^wide columns of 2^(k - wide) boxes
    std::set<std::pair<int, int>> boxes;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const glm::dvec2 point = points(i);
      boxes.emplace(static_cast<int>(std::ldexp(point.x, wide)),
                    static_cast<int>(std::ldexp(point.y, k - wide)));
    }
    REQUIRE(boxes.size() == count);
  }
}

TEST_CASE("a point may be anywhere in the square", "[tracer][points]") {
  constexpr int seeds = 4000;
  glm::dvec2 sum(0.0);
  double product = 0.0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const glm::dvec2 point = ScrambledPoints(seed)(5) - 0.5;
    REQUIRE(std::abs(point.x) < 0.5);
    REQUIRE(std::abs(point.y) < 0.5);
    sum += point;
    product += point.x * point.y;
  }
  // Four standard errors of means of variance 1/12 and 1/144.
  CHECK(std::abs(sum.x / seeds) < 4.0 * std::sqrt(1.0 / 12.0 / seeds));
  CHECK(std::abs(sum.y / seeds) < 4.0 * std::sqrt(1.0 / 12.0 / seeds));
  CHECK(std::abs(product / seeds) < 4.0 * std::sqrt(1.0 / 144.0 / seeds));
}

}  // namespace
}  // namespace raycat
