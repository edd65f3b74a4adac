#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// An object of a scene as triangles in the world, for files that know nothing else.
struct ObjectMesh {
  /// Triangles of one material.
  struct Part {
    SurfaceMesh mesh;  ///< its faces counted from the object's first; the vertices are its own
    MaterialId material{};
  };

  ObjectId object{};
  SurfaceId first_face{};
  std::vector<Part> parts;               ///< none if the object comes to nothing, or has no end
  const SolidObject* endless = nullptr;  ///< the solid that a half-space leaves without end
};

/// The objects of a scene in their order. Lone meshes are as they are; solids are evaluated, with
/// curved surfaces within `chord_error` times the half diagonal. Throws `std::runtime_error` if
/// there are solids and raycat was built without CGAL, and `std::logic_error` naming an object that
/// takes too many triangles.
std::vector<ObjectMesh> object_meshes(const Scene& scene, double chord_error);

/// Says which objects have no parts, and why: a line each.
std::vector<std::string> without_parts(const SurfaceTable& surfaces,
                                       std::span<const ObjectMesh> objects);

/// All parts in one, each position once. Triangles that two corners at one place have made nothing
/// of are left out.
TriangleMesh welded_mesh(const ObjectMesh& object);

}  // namespace raycat
