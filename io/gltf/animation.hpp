#pragma once

#include <string>

#include "io/gltf/document.hpp"

namespace raycat {

/// Puts the nodes of the document's model into the pose that an animation has at `time`, in
/// seconds: translation, rotation, scale and weights, interpolated by STEP, LINEAR (rotations on
/// the sphere) or CUBICSPLINE (glTF 2.0, appendix C). Before its first key frame a channel has
/// that frame's value, and after its last the last's. `animation` is a name or a number; empty is
/// the first. A channel that cannot be read is left out with a warning. Throws `LoadError` if the
/// animation is not there.
void pose_nodes(GltfDocument& document, double time, const std::string& animation);

}  // namespace raycat
