#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "categories/category_image.hpp"
#include "categories/detail.hpp"
#include "categories/encoder.hpp"
#include "tracer/camera.hpp"
#include "tracer/image.hpp"
#include "tracer/tracer.hpp"

namespace raycat {

struct RenderSettings {
  int width = 512;   ///< 1 or more
  int height = 512;  ///< 1 or more
  int levels = 8;    ///< of recursion, the camera ray's hit being the first; 1 to 64
  int threads = 1;   ///< 1 or more
  Method method = Method::heap;
  Detail detail;              ///< of the categories
  bool mark_textures = true;  ///< fill `CategoryImage::textured`

  /// Called now and then with the rows done and their number, one call at a time.
  std::function<void(int done, int rows)> progress;
};

/// An image and why each of its pixels looks as it does.
struct Rendering {
  Image colour;
  CategoryImage categories;
  RayCounts rays;
};

/// What encoders must hold for a scene at a level of detail.
Extent extent(const Scene& scene, const Detail& detail, int levels);

/// Renders the image and the categories of its samples in one pass. The result does not depend
/// on the number of threads. Throws `std::invalid_argument` for settings out of range, and
/// `std::length_error` if the method cannot hold the scene.
Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings);

/// Renders the image alone, recording nothing. One camera ray a pixel.
Image render_colour(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                    RayCounts& rays);

/// Samples between those of an image that was rendered with the same arguments.
class FinerSamples {
 public:
  /// Keeps a reference to `accel`.
  FinerSamples(const Accel& accel, Camera camera, RenderSettings settings,
               const CategoryImage& image)
      : accel_(accel),
        camera_(std::move(camera)),
        settings_(std::move(settings)),
        encoder_(*image.encoder),
        table_(image.table) {}

  /// The categories of points of the image's lattice, as `ImagePlane::sample_ray` has them.
  std::vector<CategoryId> operator()(std::span<const glm::dvec2> points);

  /// That of the image, to which new categories are added by first appearance, whatever the number
  /// of threads.
  const CategoryTable& table() const noexcept { return table_; }

  const RayCounts& rays() const noexcept { return rays_; }

 private:
  const Accel& accel_;
  Camera camera_;
  RenderSettings settings_;
  Encoder encoder_;
  CategoryTable table_;
  RayCounts rays_;
};

}  // namespace raycat
