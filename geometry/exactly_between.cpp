#include "geometry/exactly_between.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace raycat {
namespace {

// A sum of doubles with no rounding: parts that do not overlap (Shewchuk, Adaptive Precision
// Floating-Point Arithmetic, 1997, Grow-Expansion).
class ExactSum {
 public:
  void add(double value) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + parts_[i];
      const double of_part = sum - value;
      parts_[i] = (value - (sum - of_part)) + (parts_[i] - of_part);
      value = sum;
    }
    parts_[size_++] = value;
  }

  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  bool is_zero() const {
    for (std::size_t i = 0; i < size_; ++i) {
      if (parts_[i] != 0.0) {
        return false;
      }
    }
    return true;
  }

 private:
  std::array<double, 12> parts_{};  // of six products
  std::size_t size_ = 0;
};

bool in_a_row(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, int x, int y) {
  ExactSum area;
  area.add_product(a[x], b[y]);
  area.add_product(-a[y], b[x]);
  area.add_product(b[x], p[y]);
  area.add_product(-b[y], p[x]);
  area.add_product(p[x], a[y]);
  area.add_product(-p[y], a[x]);
  return area.is_zero();
}

}  // namespace

bool exactly_between(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool rises = a[axis] <= point[axis] && point[axis] <= b[axis];
    const bool falls = a[axis] >= point[axis] && point[axis] >= b[axis];
    if (!rises && !falls) {
      return false;
    }
  }
  return point != a && point != b && in_a_row(point, a, b, 0, 1) && in_a_row(point, a, b, 1, 2) &&
         in_a_row(point, a, b, 2, 0);
}

}  // namespace raycat
