#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/antialias_options.hpp"
#include "app/study/study.hpp"
#include "render/image_quality.hpp"

namespace raycat::app {

/// What a method made of a scene with some options; those of one family are joined in plots.
struct Antialiased {
  std::string family;
  std::string knobs;  ///< its options, as the command line has them
  double per_pixel = 0.0;
  double category_only = 0.0;
  double cpu = 0.0;
  double linear = 0.0;   ///< PSNR
  double encoded = 0.0;  ///< PSNR after sRGB encoding
  double similarity = 0.0;
};

/// All methods with all options on one scene at one size.
struct AntialiasSweep {
  std::string scene;
  std::string stem;  ///< of files about it
  ImageSize size;
  std::vector<Antialiased> outcomes;
};

/// The levels of the ray trees of antialiased pictures in studies.
constexpr int antialias_levels = 8;

AntialiasedPicture antialiased(const StudySettings& settings, const StudyScene& scene,
                               const ImageSize& size, const AntialiasOptions& options);

/// What others are compared with: 32 by 32 samples a pixel, or if it must be quick 6 by 6.
Pixels antialias_reference(const StudySettings& settings, const StudyScene& scene,
                           const ImageSize& size);

/// Fewer options if it must be quick. With POV-Ray where it is installed, against its own dense
/// samples.
AntialiasSweep sweep_antialiasing(const StudySettings& settings, const StudyScene& scene,
                                  const std::string& stem, const ImageSize& size,
                                  const Pixels& reference);

/// What adaptive costs at a PSNR, over what the better of the threshold method and Whitted's
/// costs with the options that suit it best; nothing if one side does not get there.
std::optional<double> cost_ratio(const AntialiasSweep& sweep, double target,
                                 const std::function<double(const Antialiased&)>& cost);

}  // namespace raycat::app
