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

}  // namespace raycat
