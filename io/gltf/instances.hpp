#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "io/files/load_budget.hpp"
#include "io/gltf/document.hpp"

namespace raycat {

/// Instances of a node's mesh that are one object together.
struct GltfInstanceGroup {
  std::string label;                   ///< after the node's name: `[7]`
  std::vector<glm::dmat4> transforms;  ///< each before the node's own
};

/// What EXT_mesh_gpu_instancing places at a node; nothing if the node has none. Each instance is a
/// group by itself, labelled by its number, unless EXT_instance_features gives instances ids: then
/// those of one id are one group, labelled by the id, in the order in which ids appear. Takes the
/// memory for them from the budget; whoever places them takes the instances. Throws `LoadError`
/// where attributes cannot be read; ids that cannot are left out with a warning.
std::optional<std::vector<GltfInstanceGroup>> instance_groups(GltfDocument& document,
                                                              std::size_t node, LoadBudget& budget);

}  // namespace raycat
