#include "app/study/plot_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

using Ticks = std::vector<double>;

TEST_CASE("axes end at round numbers around the data", "[io][plot]") {
  CHECK(PlotScale(AxisScale::linear, 0.0, 10.0).ticks() == Ticks{0, 2, 4, 6, 8, 10});
  CHECK(PlotScale(AxisScale::linear, 1.0, 8.0).ticks() == Ticks{1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(PlotScale(AxisScale::linear, -3.0, 41.0).ticks() == Ticks{-10, 0, 10, 20, 30, 40, 50});
  CHECK(PlotScale(AxisScale::binary, 64.0, 2048.0).ticks() == Ticks{64, 128, 256, 512, 1024, 2048});
  CHECK(PlotScale(AxisScale::binary, 65.0, 200.0).ticks() == Ticks{64, 128, 256});
  CHECK(PlotScale(AxisScale::decimal, 3.0, 43.0).ticks() == Ticks{2, 5, 10, 20, 50});
  CHECK(PlotScale(AxisScale::decimal, 1.0, 1e6).ticks() == Ticks{1, 10, 100, 1000, 1e4, 1e5, 1e6});
}

TEST_CASE("places are even in numbers or in factors", "[io][plot]") {
  const PlotScale linear(AxisScale::linear, 0.0, 10.0);
  CHECK(linear.place(0.0) == 0.0);
  CHECK(linear.place(2.5) == 0.25);
  CHECK(linear.place(10.0) == 1.0);
  const PlotScale decimal(AxisScale::decimal, 1.0, 1e4);
  CHECK(decimal.place(1.0) == 0.0);
  CHECK(decimal.place(100.0) == Approx(0.5));
  const PlotScale binary(AxisScale::binary, 64.0, 1024.0);
  CHECK(binary.place(128.0) == Approx(0.25));
}

TEST_CASE("one value alone has an axis around it", "[io][plot]") {
  const double value = GENERATE(0.0, 7.0, -7.0, 1e-300, 1e300, 1.0);
  const PlotScale scale(AxisScale::linear, value, value);
  CHECK(scale.place(value) == Approx(0.5).margin(0.2));
}

TEST_CASE("every range has few ticks that rise and enclose it", "[io][plot]") {
  rc::check([] {
    const auto scale = *rc::gen::element(AxisScale::linear, AxisScale::decimal, AxisScale::binary);
    const auto number = [&] {
      const double size = std::pow(10.0, *rc::gen::inRange(-3000, 3000) / 10.0);
      return scale == AxisScale::linear && *rc::gen::arbitrary<bool>() ? -size : size;
    };
    double low = number();
    double high = number();
    if (low > high) {
      std::swap(low, high);
    }
    const PlotScale axis(scale, low, high);
    const Ticks& ticks = axis.ticks();
    RC_ASSERT(ticks.size() >= std::size_t{2});
    RC_ASSERT(ticks.size() <= std::size_t{12});
    RC_ASSERT(std::ranges::is_sorted(ticks));
    RC_ASSERT(std::ranges::adjacent_find(ticks) == ticks.end());
    RC_ASSERT(axis.place(low) >= -1e-6);
    RC_ASSERT(axis.place(high) <= 1.0 + 1e-6);
    RC_ASSERT(axis.place(low) <= axis.place(high));
  });
}

TEST_CASE("ranges that no axis can show are refused", "[io][plot]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(PlotScale(AxisScale::linear, 0.0, infinity), std::invalid_argument);
  CHECK_THROWS_AS(PlotScale(AxisScale::linear, nan, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(PlotScale(AxisScale::linear, -1e301, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(PlotScale(AxisScale::linear, 2.0, 1.0), std::invalid_argument);
  CHECK_THROWS_WITH(PlotScale(AxisScale::decimal, 0.0, 1.0), Catch::Contains("cannot show 0:"));
  CHECK_THROWS_WITH(PlotScale(AxisScale::binary, -2.0, 1.0), Catch::Contains("cannot show -2:"));
}

}  // namespace
}  // namespace raycat
