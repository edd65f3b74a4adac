#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"
#include "io/openscad/item.hpp"

namespace raycat::openscad {

// What a node that makes a shape of its operands takes of a usable one, in its own frame.

/// The operand as one closed mesh. Throws `std::runtime_error` if CGAL finds none.
TriangleMesh operand_mesh(const Items& from, std::uint32_t at);

/// Points whose convex hull is the operand's. Throws as `operand_mesh` does.
std::vector<glm::dvec3> operand_points(const Items& from, std::uint32_t at);

}  // namespace raycat::openscad
