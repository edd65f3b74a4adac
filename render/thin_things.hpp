#pragma once

#include <functional>

#include <glm/vec2.hpp>

#include "tracer/camera.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// Where primitives are seen that are thinner than a pixel, so that samples at its corners may all
/// miss them: calls `visit` with points, in pixels, on the middle of each that a picture of `width`
/// x `height` shows, four a pixel or more, and one for what is small. A primitive is known by its
/// box in its own frame: meshes of thin parts are not looked into. Whether something is before it
/// is not asked.
void for_thin_things(const Scene& scene, const Camera& camera, int width, int height,
                     const std::function<void(const glm::dvec2&)>& visit);

}  // namespace raycat
