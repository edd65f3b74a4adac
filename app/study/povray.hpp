#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/view.hpp"
#include "render/image_quality.hpp"
#include "tracer/scene.hpp"

namespace raycat::app {

/// A scene as POV-Ray renders it, for comparison; needs the program `povray`.
class PovScene {
 public:
  struct Picture {
    Pixels colour;           ///< linear
    double per_pixel = 0.0;  ///< rays through the image
    double cpu = 0.0;        ///< seconds of tracing
  };

  /// Keeps references.
  PovScene(const Scene& scene, const Camera& camera, const ImageSize& size, int levels, int threads)
      : scene_(scene), camera_(camera), size_(size), levels_(levels), threads_(threads) {}

  /// The picture with these options for antialiasing, in linear light. Nothing if `povray` is not
  /// installed; throws `std::runtime_error` if it fails.
  std::optional<Picture> render(const std::vector<std::string>& options) const;

  /// The mean of `side` by `side` samples a pixel.
  std::optional<Pixels> reference(int side) const;

 private:
  std::optional<Picture> render(int side, const std::vector<std::string>& options) const;

  const Scene& scene_;
  const Camera& camera_;
  ImageSize size_;
  int levels_;
  int threads_;
};

}  // namespace raycat::app
