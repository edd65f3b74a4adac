#pragma once

#include "geometry/mesh.hpp"

namespace raycat {

/// All sums of a point of one solid and a point of the other, as a closed mesh of one face. Of
/// solids that are not convex the convex parts are summed in pairs and united. Throws
/// `std::runtime_error` if a mesh is not closed or crosses itself, or if that takes more than a
/// hundred million sums of corners.
TriangleMesh minkowski_sum(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace raycat
