#pragma once

#include <cstdint>
#include <functional>

#include "categories/category_image.hpp"
#include "categories/detail.hpp"
#include "categories/encoder.hpp"
#include "tracer/camera.hpp"
#include "tracer/image.hpp"
#include "tracer/tracer.hpp"

namespace raycat {

struct RenderSettings {
  int width = 512;
  int height = 512;
  int levels = 8;  ///< of recursion, the camera ray's hit being the first
  int threads = 1;
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
  Encoder encoder;  ///< that made the categories
  RayCounts rays;
};

/// What encoders must hold for a scene at a level of detail.
Extent extent(const Scene& scene, const Detail& detail, int levels);

/// Renders the image and the categories of its samples in one pass. The result does not depend
/// on the number of threads.
Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings);

/// Renders the image alone, recording nothing. One camera ray a pixel.
Image render_colour(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                    RayCounts& rays);

/// The categories of single points of the image plane, in pixels as `ImagePlane::ray` has them, by
/// the encoder of an image that was rendered with the same arguments. Those that are not in `table`
/// are added by first appearance, whatever the number of threads; `rays` grows by those traced.
std::vector<CategoryId> categorize(const Accel& accel, const Camera& camera,
                                   const RenderSettings& settings,
                                   std::span<const glm::dvec2> points, const Encoder& encoder,
                                   CategoryTable& table, RayCounts& rays);

}  // namespace raycat
