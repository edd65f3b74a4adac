#pragma once

#include <cmath>
#include <random>

#include "modelling/facet_rule.hpp"
#include "modelling/polygons.hpp"

namespace raycat {

inline Contour square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

inline Contour circle(double radius, int corners) {
  Contour out;
  for (int i = 0; i < corners; ++i) {
    out.push_back(radius * unit_vector(360.0 * i / corners));
  }
  return out;
}

/// Corners at whole coordinates up to `size`, in any order.
inline Contour random_contour(std::mt19937& random, int corners, double size) {
  std::uniform_real_distribution<double> place(-size, size);
  Contour out;
  for (int i = 0; i < corners; ++i) {
    out.emplace_back(std::round(place(random)), std::round(place(random)));
  }
  return out;
}

}  // namespace raycat
