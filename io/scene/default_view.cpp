#include "io/scene/default_view.hpp"

#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace raycat {
namespace {

Light shining(std::string name, const glm::dvec3& direction, float strength) {
  return {.name = std::move(name),
          .kind = Light::Kind::directional,
          .direction = glm::normalize(direction),
          .diffuse = glm::vec3(strength),
          .specular = glm::vec3(strength)};
}

}  // namespace

Camera default_camera(const SceneFile& file, double aspect, bool orthographic) {
  if (file.scene.cameras.empty()) {
    return frame(bounds(file.scene), file.viewed_from.value_or(three_quarter(file.up)), file.up,
                 aspect, orthographic);
  }
  const Camera& camera = file.scene.cameras.front();
  return orthographic ? raycat::orthographic(camera, distance_to_middle(file.scene, camera))
                      : camera;
}

double distance_to_middle(const Scene& scene, const Camera& camera) {
  const Bounds box = bounds(scene);
  return box.empty() ? 1.0 : glm::distance(camera.eye, box.center());
}

Scene lit(Scene scene, const Camera& camera) {
  if (scene.lights.empty()) {
    scene.lights.push_back(shining("headlight", camera.forward, 0.45f));
    scene.lights.push_back(
        shining("key light", camera.forward + 0.6 * camera.right - 0.9 * camera.up, 0.55f));
  }
  return scene;
}

}  // namespace raycat
