#pragma once

#include <nlohmann/json.hpp>

#include "tracer/scene.hpp"

namespace raycat {

/// Adds nodes for the cameras and lights of a scene to the document of a glTF file that is being
/// put together, and the background and ambient light to its scene. Lights of eq. (1) have
/// `whitted` extras.
void add_view_json(const Scene& scene, nlohmann::ordered_json& document);

}  // namespace raycat
