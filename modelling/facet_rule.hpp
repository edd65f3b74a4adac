#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace raycat {

/// OpenSCAD's $fn, $fa (degrees) and $fs: into how many facets circles are divided.
struct FacetRule {
  double number = 0.0;
  double angle = 12.0;
  double size = 2.0;
};

/// The corners of a circle. Throws `std::length_error` past a million.
std::uint32_t facet_count(double radius, const FacetRule& rule);

/// Cosine and sine, exact where they are rational or roots, and symmetric between the octants:
/// corners of one circle that mirror each other in the plane do so to the last bit.
glm::dvec2 unit_vector(double degrees);

}  // namespace raycat
