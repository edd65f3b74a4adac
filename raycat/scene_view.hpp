#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "io/load_scene.hpp"
#include "render/render.hpp"
#include "tracer/accel.hpp"
#include "tracer/camera.hpp"

namespace raycat {

/// A scene ready to be traced: what a file holds, a camera, lights, and the structure that finds
/// hits. It does not change once built, so any number of threads may share one; copies are cheap.
class SceneView {
 public:
  /// Loads `file`. Where it has no camera it is framed, and where it has no light a headlight and a
  /// key light go with the camera. Throws `LoadError`.
  explicit SceneView(const std::filesystem::path& file, const LoadOptions& options = {});

  /// As above, for a file already loaded, seen through `camera` if one is given.
  explicit SceneView(SceneFile file, std::optional<Camera> camera = std::nullopt);

  /// What the file held, with any lights that were added.
  const SceneFile& file() const noexcept { return held_->file; }
  const Scene& scene() const noexcept { return held_->file.scene; }
  const Accel& accel() const noexcept { return held_->accel; }

  /// The camera for a picture of this many pixels; a framed scene fills the picture.
  Camera camera(int width, int height) const;

  /// The picture and the categories of its samples (`render`, render/render.hpp). By default
  /// 512 x 512 pixels, 8 levels, full detail, and one thread. Throws as that does.
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
