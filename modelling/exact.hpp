#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <glm/vec3.hpp>

namespace raycat {

/// Points without rounding. For the sources of `modelling` alone.
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

inline Exact::Point_3 exact(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

inline glm::dvec3 rounded(const Exact::Point_3& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

}  // namespace raycat
