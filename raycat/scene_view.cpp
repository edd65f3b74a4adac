#include "raycat/scene_view.hpp"

#include <utility>

#include "io/scene/default_view.hpp"

namespace raycat {
namespace {

SceneFile lit(SceneFile file, const std::optional<Camera>& camera) {
  const Camera seen_through = camera ? *camera : default_camera(file, 1.0);
  file.scene = lit(std::move(file.scene), seen_through);
  return file;
}

}  // namespace

SceneView::Held::Held(SceneFile file_in, std::optional<Camera> camera_in)
    : file(lit(std::move(file_in), camera_in)), camera(std::move(camera_in)), accel(file.scene) {}

SceneView::SceneView(const std::filesystem::path& file, const LoadOptions& options)
    : SceneView(load_scene(file, options)) {}

SceneView::SceneView(SceneFile file, std::optional<Camera> camera)
    : held_(std::make_shared<const Held>(std::move(file), std::move(camera))) {}

Camera SceneView::camera(int width, int height) const {
  return held_->camera ? *held_->camera
                       : default_camera(held_->file, static_cast<double>(width) / height);
}

Rendering SceneView::render(const RenderSettings& settings) const {
  return raycat::render(accel(), camera(settings.width, settings.height), settings);
}

}  // namespace raycat
