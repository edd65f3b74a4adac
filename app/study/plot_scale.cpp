#include "app/study/plot_scale.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace raycat {
namespace {

constexpr double most_ticks = 8.0;

// 1, 2 or 5 times a power of ten, and `span` holds at most eight of them.
double round_step(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span / most_ticks)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (span <= most_ticks * factor * decade) {
      return factor * decade;
    }
  }
  return 10.0 * decade;
}

std::vector<double> linear_ticks(double low, double high) {
  // Values that are all but one, or all but zero, would be lost in rounding.
  constexpr double least = 1e-290;
  const double greatest = std::max(std::abs(low), std::abs(high));
  if (high - low <= std::max(1e-9 * greatest, least)) {
    const double around = greatest <= least ? 1.0 : 0.5 * greatest;
    low -= around;
    high += around;
  }
  const double step = round_step(high - low);
  const double first = std::floor(low / step + 1e-9);
  const double last = std::ceil(high / step - 1e-9);
  std::vector<double> ticks;
  for (double i = first; i <= last; i += 1.0) {
    ticks.push_back(i * step);
  }
  return ticks;
}

// Powers of `base` around the range, every so many of them.
std::vector<double> power_ticks(double base, double low, double high) {
  double first = std::floor(std::log(low) / std::log(base) + 1e-9);
  double last = std::ceil(std::log(high) / std::log(base) - 1e-9);
  last = std::max(last, first + 1.0);
  const double step = std::ceil((last - first) / most_ticks);
  std::vector<double> ticks;
  for (double power = first; power < last + step; power += step) {
    ticks.push_back(std::pow(base, power));
  }
  return ticks;
}

// 1, 2 and 5 times powers of ten where powers alone would be few.
std::vector<double> decimal_ticks(double low, double high) {
  std::vector<double> powers = power_ticks(10.0, low, high);
  if (powers.size() > 4) {
    return powers;
  }
  std::vector<double> ticks;
  for (std::size_t i = 0; i + 1 < powers.size(); ++i) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      ticks.push_back(factor * powers[i]);
    }
  }
  ticks.push_back(powers.back());
  // Those past the one next to the range on either side are not needed.
  while (ticks.size() > 2 && ticks[1] <= low * (1.0 + 1e-9)) {
    ticks.erase(ticks.begin());
  }
  while (ticks.size() > 2 && ticks[ticks.size() - 2] >= high * (1.0 - 1e-9)) {
    ticks.pop_back();
  }
  return ticks;
}

}  // namespace

PlotScale::PlotScale(AxisScale scale, double low, double high) : scale_(scale) {
  constexpr double most = 1e300;
  if (!(low >= -most && low <= high && high <= most)) {
    throw std::invalid_argument(fmt::format(
        "an axis cannot be drawn from {} to {}: it goes from -1e300 to 1e300 at most", low, high));
  }
  if (scale != AxisScale::linear && low < 1.0 / most) {
    throw std::invalid_argument(
        fmt::format("a logarithmic axis cannot show {}: it begins at 1e-300 or above", low));
  }
  switch (scale) {
    case AxisScale::linear:
      ticks_ = linear_ticks(low, high);
      break;
    case AxisScale::decimal:
      ticks_ = decimal_ticks(low, high);
      break;
    case AxisScale::binary:
      ticks_ = power_ticks(2.0, low, high);
      break;
  }
}

double PlotScale::place(double value) const noexcept {
  const double low = ticks_.front();
  const double high = ticks_.back();
  return scale_ == AxisScale::linear
             ? (value - low) / (high - low)
             : (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
}

}  // namespace raycat
