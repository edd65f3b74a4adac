#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "modelling/facet_rule.hpp"

namespace raycat::openscad {

/// Polygons counter-clockwise from outside, and the surface that each is a facet of.
struct Facets {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> surface;
};

/// A circle's corners, counter-clockwise from the +X axis on.
std::vector<glm::dvec2> circle_corners(double radius, std::uint32_t count);

/// How many triangles `facet_sphere` and `facet_cylinder` give at most for this count.
std::uint64_t sphere_triangles(std::uint32_t count);
std::uint64_t cylinder_triangles(std::uint32_t count);

/// OpenSCAD's sphere: rings of `count` corners at polar angles 180 (i + 0.5) / rings degrees,
/// flat caps, no corners at the poles. One surface.
Facets facet_sphere(double radius, std::uint32_t count);

/// From z = 0 to `height`; of the radii one may be 0. Surfaces: side, bottom unless its radius
/// is 0, top unless its radius is 0.
Facets facet_cylinder(double height, double radius_bottom, double radius_top, std::uint32_t count);

}  // namespace raycat::openscad
