#pragma once

#include <optional>
#include <span>

#include "geometry/mesh.hpp"
#include "io/openscad/context.hpp"
#include "io/openscad/primitive.hpp"
#include "modelling/polygons.hpp"

namespace raycat::openscad {

// What a node makes of its operands where they do not stay parts of it, each in the node's frame.
// All throw `NodeError` for bad parameters, and where CGAL cannot do it.

/// linear_extrude and rotate_extrude; nothing if it has no volume.
std::optional<Primitive> extruded(Context& context, const Node& node, const Polygons& operand);

/// offset and fill.
Polygons flattened(Context& context, const Node& node, const Polygons& operand);

/// projection.
Polygons projected(Context& context, const Node& node, const TriangleMesh& operand);

/// A mesh as the node's shape; nothing if it is empty. Counts its triangles.
std::optional<Primitive> solid(Context& context, const Node& node, TriangleMesh mesh);

/// A mesh that hull or minkowski made, with faces joined by `LoadOptions::faces`; nothing if it is
/// empty.
std::optional<Primitive> solid_with_faces(Context& context, const Node& node, TriangleMesh mesh);

/// The stretch of a resize node whose operands are within `box`, two- or three-dimensional.
glm::dvec3 stretch(Context& context, const Node& node, const Bounds& box);

}  // namespace raycat::openscad
