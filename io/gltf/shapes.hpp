#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shape.hpp"
#include "io/gltf/document.hpp"

namespace raycat {

/// What round shapes have where they do not say; by default that of KHR_implicit_shapes.
struct RoundDefaults {
  double cylinder_height = 0.5;
  double capsule_height = 0.5;
  double radius = 0.25;
};

/// The shape of a type that KHR_implicit_shapes defines, with the parameters in `fields`; nothing
/// for other types. A plane is a half-space. Throws `LoadError`.
std::optional<Shape> implicit_shape(const std::string& type, JsonFields& fields,
                                    const RoundDefaults& defaults = {});

/// The shapes that bodies of physics collide with: those of KHR_implicit_shapes, by
/// KHR_physics_rigid_bodies, and of OMI_physics_shape, by OMI_physics_body.
class GltfColliders {
 public:
  /// Keeps a reference to the document.
  explicit GltfColliders(const GltfDocument& document);

  bool at(std::size_t node) const;

  /// The shape of the collider at a node, which must have one. Nothing if a mesh shows the body:
  /// one at the node, above it, beside it or below it; nor for triangles and planes with borders.
  /// Throws `LoadError`.
  std::optional<Shape> shown(std::size_t node) const;

 private:
  const GltfDocument& document_;
  std::vector<bool> below_;  // is a mesh at the node or below it?
  std::vector<bool> above_;  // or above?
};

}  // namespace raycat
