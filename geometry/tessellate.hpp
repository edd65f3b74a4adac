#pragma once

#include "geometry/mesh.hpp"
#include "geometry/shape.hpp"

namespace raycat {

/// A bounded shape as triangles that close a volume, counter-clockwise from outside, with the
/// shape's own faces. Corners lie on the surface, and no point of the triangles is farther than
/// `chord_error` from it, in the shape's units. Boxes and meshes are exact. Throws
/// `std::invalid_argument` for a half-space, and if the shape would take more than 2^22 triangles.
TriangleMesh tessellate(const Shape& shape, double chord_error);

}  // namespace raycat
