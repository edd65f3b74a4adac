#pragma once

#include <cstdint>
#include <vector>

#include "io/gltf/primitive.hpp"
#include "io/scene/scene_file.hpp"

namespace raycat {

/// What of a mesh is one primitive to us: a glTF primitive, or several that continue each other.
struct GltfSurface {
  std::size_t first_primitive = 0;  ///< the first of them, among those given
  std::uint32_t face_count = 0;
};

/// Primitives as surfaces, in the order of their first primitives.
struct GltfSurfaces {
  std::vector<GltfSurface> surfaces;
  std::vector<std::size_t> of;  ///< the surface of each primitive
};

/// Finds the faces, by the rule of `options`, of the primitives that the file does not tell them
/// of. Unless `options` says otherwise, those of one material and with the same attributes are
/// looked at as if they were one, and they are one surface if any face has triangles of both, and
/// so on. The faces of a surface are counted through all of its primitives.
GltfSurfaces find_faces(std::vector<GltfPrimitive>& primitives, const LoadOptions& options);

}  // namespace raycat
