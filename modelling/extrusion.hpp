#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "geometry/mesh.hpp"
#include "modelling/facet_rule.hpp"
#include "modelling/polygons.hpp"

namespace raycat {

/// OpenSCAD's linear_extrude: layers from `z0` to `z0 + height`, each turned and then scaled in
/// proportion to its height.
struct LinearExtrusion {
  double height = 100.0;  ///< positive
  double z0 = 0.0;
  double twist = 0.0;        ///< degrees, clockwise seen from above, of the top
  glm::dvec2 scale{1.0};     ///< of the top; not negative
  std::uint32_t slices = 1;  ///< at least 1
};

/// How many slices OpenSCAD takes where its `slices` is absent or below 1, from all else that
/// `extrusion` says: 1 unless the walls are not flat, else by the longest helix or edge of a wall.
/// Throws `std::length_error` past a million.
std::uint32_t default_slices(const Polygons& polygons, const LinearExtrusion& extrusion,
                             const FacetRule& rule);

/// A closed mesh, empty if the polygons are. Faces: the bottom, the top unless its area is 0, then
/// the walls of each contour, one for each run of edges that turn less than 30 degrees from one to
/// the next. Throws `std::length_error` if there were 2^32 corners.
TriangleMesh linear_extrusion(const Polygons& polygons, const LinearExtrusion& extrusion);

/// OpenSCAD's rotate_extrude: the right half plane, its y axis raised to the z axis, swept about
/// that. A full turn begins at the negative x axis, any other at the positive one, the way that
/// `angle` says, and in steps of one angle. What lies left of the axis is swept on that side.
struct RotateExtrusion {
  double angle = 360.0;  ///< degrees, counter-clockwise; a full turn from 360 up and from -360 down
  std::uint32_t fragments = 3;  ///< steps; at least 1, and 3 for a full turn
};

/// How many steps OpenSCAD takes: the facets of a circle through the point farthest from the axis,
/// or the share of them that falls on the angle, rounded down, but at least 1.
std::uint32_t default_fragments(const Polygons& polygons, double angle, const FacetRule& rule);

/// A closed mesh, empty if the polygons or the angle are. Faces: the two caps, unless the turn is
/// full, then as for a linear extrusion; edges on the axis have none. Throws
/// `std::invalid_argument` if the polygons reach to both sides of the axis, and
/// `std::length_error` if there were 2^32 corners.
TriangleMesh rotate_extrusion(const Polygons& polygons, const RotateExtrusion& extrusion);

}  // namespace raycat
