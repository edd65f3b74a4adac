#include "geometry/quartic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace raycat {
namespace {

template <typename Real, std::size_t N>
using Coefficients = std::array<Real, N>;

template <typename Real, std::size_t N>
Real value(const Coefficients<Real, N>& c, Real x) noexcept {
  Real sum = c[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) {
    sum = sum * x + c[i];
  }
  return sum;
}

template <typename Real, std::size_t N>
Coefficients<Real, N - 1> derivative(const Coefficients<Real, N>& c) noexcept {
  Coefficients<Real, N - 1> result;
  for (std::size_t i = 1; i < N; ++i) {
    result[i - 1] = static_cast<Real>(i) * c[i];
  }
  return result;
}

template <typename Real>
struct Bracket {
  Real lower;
  Real upper;
  bool negative_at_lower;  ///< and not so at upper, or the other way round
};

// Where the parabola through value, slope and bend at the bound with the lesser value meets 0 in
// the bracket; else the middle. It is close also to a turning point, where Newton's method is slow.
template <std::size_t N>
double first_guess(const Coefficients<double, N>& c, const Coefficients<double, N - 1>& slope,
                   const Bracket<double>& in) noexcept {
  const double at_lower = value(c, in.lower);
  const double at_upper = value(c, in.upper);
  const bool from_lower = std::abs(at_lower) < std::abs(at_upper);
  const double x = from_lower ? in.lower : in.upper;
  const double y = from_lower ? at_lower : at_upper;
  const double dy = value(slope, x);
  const double root = std::sqrt(dy * dy - 2.0 * y * value(derivative(slope), x));
  // Of the parabola's two roots, the one towards the inside of the bracket.
  const double guess = x - 2.0 * y / (dy + (in.negative_at_lower ? root : -root));
  return guess > in.lower && guess < in.upper ? guess : 0.5 * (in.lower + in.upper);
}

// The root in the bracket, by Newton's method from `x` where that converges and by bisection
// where it does not. A last step of `enough`, relative to x, is enough.
template <typename Real, std::size_t N>
Real refine(const Coefficients<Real, N>& c, const Coefficients<Real, N - 1>& slope,
            Bracket<Real> in, Real x, Real enough) noexcept {
  const Real least =
      std::numeric_limits<Real>::epsilon() * std::max(std::abs(in.lower), std::abs(in.upper));
  Real step = in.upper - in.lower;
  while (in.upper - in.lower > least) {
    const Real y = value(c, x);
    if (y == Real{0}) {
      return x;
    }
    ((y < Real{0}) == in.negative_at_lower ? in.lower : in.upper) = x;
    const Real newton = -y / value(slope, x);
    const Real next = x + newton;
    if (next > in.lower && next < in.upper && std::abs(newton) < Real(0.6) * std::abs(step)) {
      step = newton;
      x = next;
      if (std::abs(step) <= enough * std::abs(x) + least) {
        break;  // Newton's method squares the error: what is left is far below its last step
      }
    } else {
      step = Real(0.5) * (in.upper - in.lower);
      x = in.lower + step;
    }
  }
  return x;
}

// Where a parabola, and then a cubic, may change sign. These turning points split the line for
// the next degree. An error in them changes the value there by its square only, so `double` and
// a rough last step do.
template <std::size_t N>
struct Turns {
  std::array<double, N> at{};
  std::size_t count = 0;

  void push_back(double x) noexcept { at[count++] = x; }
};

constexpr double rough = 1e-8;

Turns<2> turns(const Coefficients<double, 3>& c, double lower, double upper) noexcept {
  Turns<2> result;
  const double half_b = 0.5 * c[1];
  const double discriminant = half_b * half_b - c[2] * c[0];
  if (discriminant > 0.0) {
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    const auto [first, last] = std::minmax({q / c[2], c[0] / q});
    for (const double x : {first, last}) {
      if (x > lower && x < upper) {
        result.push_back(x);
      }
    }
  }
  return result;
}

Turns<3> turns(const Coefficients<double, 4>& c, double lower, double upper) noexcept {
  const Coefficients<double, 3> slope = derivative(c);
  Turns<2> splits = turns(slope, lower, upper);
  Turns<3> result;
  double last = lower;
  bool negative = value(c, lower) < 0.0;
  for (std::size_t i = 0; i <= splits.count; ++i) {
    const double next = i < splits.count ? splits.at[i] : upper;
    if ((value(c, next) < 0.0) != negative) {
      const Bracket<double> in{.lower = last, .upper = next, .negative_at_lower = negative};
      result.push_back(refine(c, slope, in, first_guess(c, slope, in), rough));
      negative = !negative;
    }
    last = next;
  }
  return result;
}

// Fujiwara's bound: no root is further from 0.
long double root_bound(const Quartic& c, std::size_t degree) noexcept {
  long double most = 0.0L;
  for (std::size_t i = 0; i < degree; ++i) {
    most = std::max(
        most, std::pow(std::abs(c[i] / c[degree]), 1.0L / static_cast<long double>(degree - i)));
  }
  return 2.0L * most;
}

template <std::size_t N>
Coefficients<double, N> round(const Coefficients<long double, N>& c) noexcept {
  Coefficients<double, N> result;
  std::ranges::transform(c, result.begin(), [](long double x) { return static_cast<double>(x); });
  return result;
}

}  // namespace

Roots sign_changes(const Quartic& quartic, const RootBound& lower, const RootBound& upper) {
  const Coefficients<long double, 4> slope = derivative(quartic);
  const Coefficients<double, 5> rounded = round(quartic);
  const Coefficients<double, 4> rounded_slope = round(slope);
  const Turns<3> splits =
      turns(rounded_slope, static_cast<double>(lower.x), static_cast<double>(upper.x));
  Roots roots;
  RootBound last = lower;
  for (std::size_t i = 0; i <= splits.count; ++i) {
    RootBound next = upper;
    if (i < splits.count) {
      next.x = splits.at[i];
      next.negative = value<long double>(quartic, next.x) < 0.0L;
    }
    if (next.negative != last.negative) {
      const Bracket<double> near{.lower = static_cast<double>(last.x),
                                 .upper = static_cast<double>(next.x),
                                 .negative_at_lower = last.negative};
      const double guess =
          refine(rounded, rounded_slope, near, first_guess(rounded, rounded_slope, near), rough);
      const Bracket<long double> in{
          .lower = last.x, .upper = next.x, .negative_at_lower = last.negative};
      roots.push_back(
          refine<long double>(quartic, slope, in, guess, std::numeric_limits<double>::epsilon()));
    }
    last = next;
  }
  return roots;
}

Roots real_roots(const Quartic& quartic) {
  std::size_t degree = quartic.size() - 1;
  while (degree > 0 && quartic[degree] == 0.0L) {
    --degree;
  }
  if (degree == 0) {
    return {};
  }
  // Past the bound the leading term decides the sign, also where rounding would hide it.
  const long double bound = root_bound(quartic, degree);
  const bool negative = quartic[degree] < 0.0L;
  return sign_changes(quartic, {.x = -bound, .negative = negative != (degree % 2 == 1)},
                      {.x = bound, .negative = negative});
}

}  // namespace raycat
