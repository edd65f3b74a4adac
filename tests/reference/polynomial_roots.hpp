#pragma once

#include <vector>

#include "reference/line.hpp"

namespace raycat::reference {

/// The real roots at which the polynomial changes sign, ascending. Coefficients from the constant
/// one upwards. Between two roots of its derivative a polynomial has at most one; halving finds it.
std::vector<Real> roots(const std::vector<Real>& coefficients);

}  // namespace raycat::reference
