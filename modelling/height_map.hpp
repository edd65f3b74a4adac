#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"

namespace raycat {

/// OpenSCAD's surface(): heights at whole x, in rows at whole y from 0 on (a text's first row, an
/// image's last), over a base 1 below the lowest, but never above 0. Rows that are shorter than
/// others go on at 0. Each cell has a corner more in its middle, at the mean of its four. Centred,
/// x and y are; z is not. Faces: the surface, the base, and the walls at low y, high x, high y and
/// low x. Empty if there is no cell. Throws `std::length_error` past 100 million heights.
TriangleMesh height_map(const std::vector<std::vector<double>>& rows, bool centred);

/// The height that OpenSCAD gives a pixel with channels from 0 to 255: up to 100. Its `invert` is
/// not what its manual says, but takes the height from that of a channel of 1.
double pixel_height(const glm::dvec3& colour, bool invert);

}  // namespace raycat
