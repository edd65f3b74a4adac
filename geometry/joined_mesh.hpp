#pragma once

#include <cstdint>
#include <span>

#include "geometry/mesh.hpp"
#include "geometry/placed_shape.hpp"

namespace raycat {

/// `mesh` where `transform` puts it. A transform that mirrors turns the triangles, so that they
/// stay counter-clockwise from outside.
TriangleMesh placed(TriangleMesh mesh, const Affine& transform);

/// Adds the triangles of `mesh` to `all`, its faces counted from `first_face`.
void append(TriangleMesh& all, const TriangleMesh& mesh, std::uint32_t first_face);

/// All triangles as one mesh, each mesh's faces after those of the meshes before it.
TriangleMesh joined(std::span<const TriangleMesh* const> meshes);

/// Leaves each position once, in the order of their first corners, and no triangle that has two
/// corners at one place.
void weld_corners(TriangleMesh& mesh);

}  // namespace raycat
