#pragma once

#include <array>
#include <cstddef>

namespace raycat {

/// The polynomial c[0] + c[1] x + ... + c[4] x^4.
using Quartic = std::array<long double, 5>;

/// Up to four numbers, ascending.
class Roots {
 public:
  std::size_t size() const noexcept { return size_; }
  long double operator[](std::size_t i) const noexcept { return at_[i]; }
  const long double* begin() const noexcept { return at_.data(); }
  const long double* end() const noexcept { return at_.data() + size_; }

  void push_back(long double x) noexcept { at_[size_++] = x; }

 private:
  std::array<long double, 4> at_{};
  std::size_t size_ = 0;
};

/// One end of an interval, and whether the polynomial is negative there. The caller may know
/// the sign better than rounding lets it be computed.
struct RootBound {
  long double x = 0.0L;
  bool negative = false;
};

/// Where the quartic changes sign between the two bounds: an even number of places if it has
/// the same sign at both, else an odd number.
///
/// The quartic is monotone between the roots of its derivative, which are found the same way, so
/// every change is bracketed before it is approached by Newton's method. Two roots are found as
/// long as the quartic exceeds its own rounding error of a few 1e-19 (of its largest term)
/// between them, and are then as accurate as that error over the slope: with terms of order 1,
/// two roots 1e-6 apart are right to 1e-13. A root of even multiplicity is found as two nearby
/// ones or not at all, and not at all if the quartic is exactly 0 there and else positive. Where
/// `long double` is no longer than `double`, read 1e-16 for 1e-19 and 1e-10 for 1e-13.
Roots sign_changes(const Quartic& quartic, const RootBound& lower, const RootBound& upper);

/// All real roots of a polynomial of any degree to 4, in the sense and with the errors of
/// `sign_changes`. None if it is constant.
Roots real_roots(const Quartic& quartic);

}  // namespace raycat
