#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "io/load_scene.hpp"
#include "render/render.hpp"
#include "tracer/accel.hpp"
#include "tracer/camera.hpp"

namespace raycat {

/// A scene as it is looked at, ready to be traced: what a file holds, the camera, lights, and the
/// structure that finds what a ray hits. Nothing of it changes any more, so that any number of
/// threads may use one, and copies share it.
class SceneView {
 public:
  /// Loads `file`. Where it has no camera it is framed, and where it has no light a headlight and a
  /// key light go with the camera. Throws `LoadError`.
  explicit SceneView(const std::filesystem::path& file, const LoadOptions& options = {});

  /// The same of a file that is loaded, seen through `camera` if it is given.
  explicit SceneView(SceneFile file, std::optional<Camera> camera = std::nullopt);

  /// What the file held, its scene lit.
  const SceneFile& file() const noexcept { return held_->file; }
  const Scene& scene() const noexcept { return held_->file.scene; }
  const Accel& accel() const noexcept { return held_->accel; }

  /// The camera for a picture of this many pixels; a scene that is framed fills it.
  Camera camera(int width, int height) const;

  /// The picture and the categories of its samples (`render`, render/render.hpp). By default
  /// 512 x 512 pixels, 8 levels, all that ray trees tell, and one thread.
  Rendering render(const RenderSettings& settings = {}) const;

 private:
  struct Held {
    Held(SceneFile file_in, std::optional<Camera> camera_in);

    SceneFile file;
    std::optional<Camera> camera;  // none: the default one
    Accel accel;
  };

  std::shared_ptr<const Held> held_;
};

}  // namespace raycat
