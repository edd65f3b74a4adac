#pragma once

#include <span>
#include <vector>

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

#include "csg/tree.hpp"

namespace raycat {

/// A closed row of corners. The last is joined to the first and is not repeated.
using Contour = std::vector<glm::dvec2>;

/// A region of the plane as its boundary: what is inside lies to the left of every edge, so that
/// outer contours run counter-clockwise and holes clockwise. Contours do not cross themselves or
/// each other but may touch at corners; the functions below give such, up to the rounding of
/// coordinates to `double`, and take any.
struct Polygons {
  std::vector<Contour> contours;
};

/// What is enclosed by an odd number of the contours, whichever way they run and however they
/// cross. This is OpenSCAD's `polygon(points, paths)`. Corners that lie in a straight edge are
/// dropped, here and in all that follows. Throws `std::invalid_argument` if a coordinate is not
/// finite, and `std::length_error` if edges meet in more than 200 000 places besides corners.
Polygons even_odd(std::span<const Contour> contours);

/// The union or intersection of all, or the first minus the others. Nothing, if given nothing.
Polygons combined(Operation operation, std::span<const Polygons> operands);

/// The image under an affine map (columns: those of x and y, and the origin). A mirror image is
/// turned to run the right way; of a map that flattens the plane nothing is left. Throws
/// `std::invalid_argument` if a coordinate comes to be infinite.
Polygons transformed(const Polygons& polygons, const glm::dmat3x2& map);

/// The convex hull of all together.
Polygons hull(std::span<const Polygons> operands);

/// All sums of a point of one and a point of the other. Throws `std::length_error` if the numbers
/// of corners of two pieces multiply to more than a million, or 100 000 if neither is convex.
Polygons minkowski_sum(const Polygons& a, const Polygons& b);

/// Without the holes.
Polygons filled(const Polygons& polygons);

/// Twice the signed area summed over the contours, halved: the area if they are regular.
double area(const Polygons& polygons);

}  // namespace raycat
