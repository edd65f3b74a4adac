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
  Detail detail;  ///< of the categories

  /// Called now and then with the rows done and their number, one call at a time.
  std::function<void(int done, int rows)> progress;
};

/// An image and why each of its pixels looks as it does.
struct Rendering {
  Image colour;
  CategoryImage categories;
  RayCounts rays;
  std::uint64_t textured_pixels = 0;  ///< whose tree meets a textured surface (Section 4.2)
  Extent extent;                      ///< that the encoder was chosen for
};

/// What encoders must hold for a scene at a level of detail.
Extent extent(const Scene& scene, const Detail& detail, int levels);

/// Renders the image and the categories of its samples in one pass. The result does not depend
/// on the number of threads.
Rendering render(const Accel& accel, const Camera& camera, const RenderSettings& settings);

/// Renders the image alone, recording nothing. One camera ray a pixel.
Image render_colour(const Accel& accel, const Camera& camera, const RenderSettings& settings,
                    RayCounts& rays);

}  // namespace raycat
