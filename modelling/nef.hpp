#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"

namespace raycat {

// What CGAL's Nef polyhedra are for. Their templates take most of a minute to compile, so all that
// needs them is in one source, which alone includes them.

/// The corners of convex bodies that together are the solid that `mesh` encloses. One if that is
/// convex. Throws `std::runtime_error` if the mesh is not closed or crosses itself.
std::vector<std::vector<glm::dvec3>> convex_parts(const TriangleMesh& mesh);

/// The union of what closed meshes enclose, at least one, as a closed mesh of one face in doubles.
/// Throws `std::runtime_error` if a mesh is not closed or touches itself along an edge.
TriangleMesh united(std::span<const TriangleMesh> meshes);

}  // namespace raycat
