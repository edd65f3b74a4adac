#pragma once

#include <cstdint>
#include <memory>
#include <variant>

#include <glm/vec3.hpp>

#include "geometry/bounds.hpp"
#include "geometry/crossing.hpp"
#include "geometry/ray.hpp"

namespace raycat {

class ClosedMesh;

// The solid shapes, each in its own frame: centred on the origin, axis +Y, parameters named as
// in glTF's KHR_implicit_shapes. Each `cross` appends every crossing of the whole line (t from
// minus to plus infinity) in ascending t, entering and leaving in turn, and returns whether the
// line is inside at t -> -infinity, which only a half-space ever is. Faces are numbered from 0
// in the order given.
//
// A shape is half open, so that two that share a face never both hold a line in it: a line that
// only touches does not cross.

/// One face.
struct Sphere {
  double radius = 1.0;
};

/// Six faces: -x, +x, -y, +y, -z, +z.
struct Box {
  glm::dvec3 size{1.0};  ///< full extents
};

/// A cylinder, or with two radii a cone or its frustum. Faces: side, bottom cap if its radius
/// is not zero, top cap if its radius is not zero.
struct Cylinder {
  double height = 1.0;
  double radius_top = 0.5;
  double radius_bottom = 0.5;
};

/// The convex hull of two balls whose centres lie `height` apart. One face, since its surface
/// has no crease.
struct Capsule {
  double height = 1.0;
  double radius_top = 0.5;
  double radius_bottom = 0.5;
};

/// The half-space below y = 0. One face. A line in it is outside.
struct HalfSpace {};

/// A ring around the Y axis: `radius` to the middle of the tube, `tube` its radius. Spindle
/// tori (tube > radius) are the solid of revolution's union. One face.
struct Torus {
  double radius = 1.0;
  double tube = 0.25;
};

/// Triangles that close a volume; polyhedra are meshes whose faces are their polygons. Never
/// null. Shared, since instances and operands may place one mesh many times.
using MeshShape = std::shared_ptr<const ClosedMesh>;

using Shape = std::variant<Sphere, Box, Cylinder, Capsule, HalfSpace, Torus, MeshShape>;

bool cross(const Sphere& sphere, const Ray& ray, Crossings& out);
bool cross(const Box& box, const Ray& ray, Crossings& out);
bool cross(const Cylinder& cylinder, const Ray& ray, Crossings& out);
bool cross(const Capsule& capsule, const Ray& ray, Crossings& out);
bool cross(const HalfSpace& half_space, const Ray& ray, Crossings& out);
bool cross(const Torus& torus, const Ray& ray, Crossings& out);
bool cross(const MeshShape& mesh, const Ray& ray, Crossings& out);
bool cross(const Shape& shape, const Ray& ray, Crossings& out);

/// Exact in the shape's own frame; a half-space's are infinite.
Bounds bounds(const Shape& shape);

/// At least 1.
std::uint32_t face_count(const Shape& shape);

/// Throws `std::invalid_argument` naming the parameter that is not finite, negative, or leaves
/// no volume, as glTF names it: `radius must be a finite number above 0, but is -1`.
void validate(const Shape& shape);

}  // namespace raycat
