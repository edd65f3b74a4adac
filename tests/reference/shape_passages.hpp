#pragma once

#include <vector>

#include "geometry/shape.hpp"
#include "reference/line.hpp"

namespace raycat::reference {

/// Is a point of the shape's own frame inside? By the definition of each shape; of a mesh, where
/// its winding number is positive, counted along another line than any that is asked for.
bool contains(const Shape& shape, const Vec& point);

/// The passages of a line through the shape's surface, both in its own frame, in ascending t. All
/// roots of all surfaces that bound the shape are found; those are passages across which `contains`
/// differs.
std::vector<Passage> passages(const Shape& shape, const Line& line);

}  // namespace raycat::reference
