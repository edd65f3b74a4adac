#pragma once

#include "io/scene/scene_file.hpp"
#include "tracer/camera.hpp"

namespace raycat {

/// How a scene is seen where nobody says: through the file's first camera, or else one that views
/// all of it from the side that the file's kind is used to. `aspect` is width over height; the
/// directions of such a camera do not depend on it.
Camera default_camera(const SceneFile& file, double aspect, bool orthographic = false);

/// How far `camera` is from the middle of the scene; 1 if that is empty. What lies there keeps its
/// size when the camera is made orthographic.
double distance_to_middle(const Scene& scene, const Camera& camera);

/// `scene`, with a headlight and a key light that go with `camera` if it has no light.
Scene lit(Scene scene, const Camera& camera);

}  // namespace raycat
