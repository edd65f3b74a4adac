#pragma once

#include <vector>

namespace raycat {

/// How an axis of a plot runs: evenly, by factors of ten, or by factors of two.
enum class AxisScale { linear, decimal, binary };

/// An axis from data to places on it, its ends at round numbers.
class PlotScale {
 public:
  /// Spans the values from `low` to `high`. Throws `std::invalid_argument` unless these rise and
  /// are at most 1e300 from zero, and for a logarithmic scale at least 1e-300.
  PlotScale(AxisScale scale, double low, double high);

  /// Where `value` stands: 0 at the low end and 1 at the high end.
  double place(double value) const noexcept;

  /// Round values to be marked, rising, the ends among them.
  const std::vector<double>& ticks() const noexcept { return ticks_; }

 private:
  AxisScale scale_;
  std::vector<double> ticks_;
};

}  // namespace raycat
