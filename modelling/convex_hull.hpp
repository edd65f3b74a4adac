#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"

namespace raycat {

/// The convex hull of points as triangles, counter-clockwise from outside, all of face 0. Corners
/// are points given, to the last bit but for the sign of zeros, and none lies on an edge or within
/// a facet. The order of the points does not matter. No triangles if the points lie in one plane.
/// Coordinates must be finite.
TriangleMesh convex_hull(std::span<const glm::dvec3> points);

}  // namespace raycat
