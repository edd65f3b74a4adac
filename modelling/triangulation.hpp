#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "modelling/polygons.hpp"

namespace raycat {

/// Polygons and what they enclose as counter-clockwise triangles. Triangles index the corners of
/// all contours in their order; a corner at one place with another may stand for it. The edges of
/// the triangles are those of the contours, and others that two triangles run along opposite ways.
struct Triangulation {
  Polygons polygons;
  std::vector<glm::uvec3> triangles;
};

/// Polygons that cross themselves, as rounding may leave them, are made regular first.
Triangulation triangulated(Polygons polygons);

}  // namespace raycat
