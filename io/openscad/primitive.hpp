#pragma once

#include <optional>

#include <glm/mat4x4.hpp>

#include "geometry/mesh.hpp"
#include "geometry/shape.hpp"
#include "io/openscad/context.hpp"

namespace raycat::openscad {

/// A shape and where it stands in the frame of its node.
struct Primitive {
  Shape shape;
  glm::dmat4 frame{1.0};
};

/// Are round things as `LoadOptions::facets` asks, or in facets whatever it says, since what they
/// are an operand of works on triangles?
enum class Roundness { as_asked, faceted };

/// The solid of a cube, sphere, cylinder or polyhedron node; nothing if it has no volume, as
/// OpenSCAD sees it. Throws `NodeError` for a parameter of the wrong type, a polyhedron that is not
/// closed, or too many triangles in the file.
std::optional<Primitive> solid_primitive(Context& context, const Node& node, Roundness roundness);

/// A mesh as a solid, turned inside out if its volume is negative. Throws `NodeError` if it is not
/// closed.
Shape closed(const Node& node, TriangleMesh mesh);

}  // namespace raycat::openscad
