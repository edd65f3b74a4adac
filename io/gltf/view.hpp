#pragma once

#include <vector>

#include "io/gltf/document.hpp"
#include "io/gltf/nodes.hpp"
#include "tracer/camera.hpp"
#include "tracer/light.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// The cameras of `nodes`. A camera whose view has no size is left out with a warning. Throws
/// `LoadError`.
std::vector<Camera> read_cameras(GltfDocument& document, const GltfNodes& nodes);

/// The lights of KHR_lights_punctual at `nodes`. With `whitted` extras a light is eq. (1)'s, else
/// glTF's, whose intensity counts 2^`exposure` times. Throws `LoadError`, also past 64 lights.
std::vector<Light> read_lights(const GltfDocument& document, const GltfNodes& nodes,
                               double exposure);

/// Sets the background and ambient light of `scene`, where the extras of the glTF scene give them.
/// Throws `LoadError`.
void read_surroundings(const GltfDocument& document, Scene& scene);

}  // namespace raycat
