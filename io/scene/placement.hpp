#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "csg/tree.hpp"
#include "io/scene/assembly.hpp"

namespace raycat {

/// Where a scene is put as a part of another.
struct Placement {
  glm::dmat4 world{1.0};
  std::string name;                  ///< goes before the part's own names
  std::uint32_t first_material = 0;  ///< number of the part's first material in the whole
};

/// Adds a part's materials and textures to `to` and returns the number of the first material.
std::uint32_t add_materials(const Scene& part, Scene& to);

/// A CSG tree under construction, with one material a leaf.
struct TreeAssembly {
  CsgTree tree;
  std::vector<MaterialId> materials;
};

/// A copy of `part`'s objects as objects of `to`. Throws `std::invalid_argument` if
/// `placement.world` is singular.
void place_objects(const Scene& part, const Placement& placement, SceneAssembly& to);

/// A copy of `part`'s objects as operands in `tree`. Throws `std::invalid_argument` if
/// `placement.world` is singular or a mesh is not closed.
std::vector<CsgTree::NodeId> place_operands(const Scene& part, const Placement& placement,
                                            SceneAssembly& to, TreeAssembly& tree);

}  // namespace raycat
