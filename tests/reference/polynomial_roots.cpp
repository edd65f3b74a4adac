#include "reference/polynomial_roots.hpp"

#include <cmath>
#include <cstddef>

namespace raycat::reference {
namespace {

Real value(const std::vector<Real>& coefficients, Real t) {
  Real sum = 0.0L;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    sum = sum * t + coefficients[i];
  }
  return sum;
}

// All roots lie within this of zero (Cauchy).
Real bound(const std::vector<Real>& coefficients) {
  Real most = 0.0L;
  for (std::size_t i = 0; i + 1 < coefficients.size(); ++i) {
    most = std::max(most, std::abs(coefficients[i] / coefficients.back()));
  }
  return 1.0L + most;
}

}  // namespace

std::vector<Real> roots(const std::vector<Real>& coefficients) {
  std::vector<Real> p(coefficients);
  while (!p.empty() && p.back() == 0.0L) {
    p.pop_back();
  }
  if (p.size() < 2) {
    return {};
  }
  if (p.size() == 2) {
    return {-p[0] / p[1]};
  }
  std::vector<Real> derivative;
  for (std::size_t i = 1; i < p.size(); ++i) {
    derivative.push_back(static_cast<Real>(i) * p[i]);
  }
  std::vector<Real> ends = roots(derivative);
  ends.insert(ends.begin(), -bound(p));
  ends.push_back(bound(p));
  std::vector<Real> found;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    Real low = ends[i];
    Real high = ends[i + 1];
    const bool rises = value(p, low) < 0.0L;
    if (rises == (value(p, high) < 0.0L)) {
      continue;
    }
    while (true) {
      const Real middle = low + (high - low) / 2.0L;
      if (middle <= low || middle >= high) {
        break;
      }
      ((value(p, middle) < 0.0L) == rises ? low : high) = middle;
    }
    found.push_back(low);
  }
  return found;
}

}  // namespace raycat::reference
