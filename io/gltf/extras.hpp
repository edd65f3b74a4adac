#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "csg/tree.hpp"
#include "geometry/shape.hpp"
#include "io/gltf/document.hpp"
#include "tracer/camera.hpp"

namespace raycat {

/// Which material the surfaces get that a subtraction leaves.
enum class CutMaterial { operand, base };

/// What raycat's own keys in a node's extras say (docs/scene-files.md). Other keys are someone
/// else's.
struct NodeExtras {
  struct Asset {
    std::string uri;
    std::optional<std::string> node;
  };

  std::optional<Operation> csg;
  CutMaterial cut_material = CutMaterial::operand;
  std::optional<Shape> shape;
  std::optional<std::size_t> material;  ///< of the shape
  std::optional<Camera> look_at;        ///< only its pose
  std::optional<Asset> asset;
};

/// Throws `LoadError` naming the node. Parameters that a shape leaves out are those of
/// KHR_implicit_shapes: sphere radius 0.5, box size 1, cylinder and capsule height 0.5 and radii
/// 0.25; ours for a torus are radius 0.5 and tube 0.25. A polyhedron needs both of its own.
NodeExtras node_extras(const GltfDocument& document, std::size_t node);

}  // namespace raycat
