#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "io/gltf/mesh.hpp"
#include "io/gltf/nodes.hpp"

namespace raycat {

/// The matrices that move a skin's vertices (glTF 2.0, 3.7.3.3): of each joint its place in the
/// world times its inverse bind matrix. Throws `LoadError` for a skin that cannot be read.
std::vector<glm::dmat4> joint_matrices(const GltfDocument& document, std::size_t skin,
                                       const GltfNodes& nodes);

/// A primitive's mesh with its morph targets added by `weights`, those that are missing being 0,
/// and then moved by its skin; `joints` may be empty for none. Faces stay those of `rest`. Throws
/// `LoadError` where the attributes do not fit the mesh.
std::shared_ptr<SurfaceMesh> deformed(const GltfDocument& document, std::size_t mesh,
                                      const GltfPrimitive& rest, std::span<const double> weights,
                                      std::span<const glm::dmat4> joints);

}  // namespace raycat
