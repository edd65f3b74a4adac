#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"

namespace raycat {

/// The corners of convex bodies that together are the solid that `mesh` encloses. One if that is
/// convex. Throws `std::runtime_error` if the mesh is not closed or crosses itself.
std::vector<std::vector<glm::dvec3>> convex_parts(const TriangleMesh& mesh);

}  // namespace raycat
