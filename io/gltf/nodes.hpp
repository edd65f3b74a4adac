#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "io/gltf/document.hpp"

namespace raycat {

/// The nodes of a scene: parents before children, each subtree in one piece.
struct GltfNodes {
  std::vector<std::size_t> order;
  std::vector<bool> hidden;       ///< of every node: by KHR_node_visibility, its own or above
  std::vector<glm::dmat4> world;  ///< of every node of the document; only of those in `order` set
};

/// The nodes of the scene of a name or number; if that is empty, of the default scene: `scene`,
/// else the first, else all nodes. Throws `LoadError` if there is no such scene, or a transform is
/// not affine.
GltfNodes scene_nodes(const GltfDocument& document, const std::string& wanted);

/// The first node called `name` and what is below it, without the transforms above it.
/// `std::nullopt` if there is none.
std::optional<GltfNodes> nodes_below(const GltfDocument& document, const std::string& name);

}  // namespace raycat
