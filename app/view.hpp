#pragma once

#include <optional>
#include <string>

#include "io/scene/scene_file.hpp"
#include "tracer/camera.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace raycat::app {

/// How a scene is looked at and traced: the options that `render` and `probe` share.
struct ViewOptions {
  std::string size = "512x512";
  std::string camera;
  std::string view;
  std::string orbit;  ///< AZIMUTH,ELEVATION[,DISTANCE], in degrees and units of the scene
  std::string up;     ///< x,y,z; the scene's own if empty
  bool orthographic = false;
  int levels = 8;  ///< of recursion
};

void add_view(CLI::App& command, ViewOptions& options);

struct ImageSize {
  int width = 0;
  int height = 0;
};

inline constexpr int most_image_side = 65536;
inline constexpr long long most_pixels = 1LL << 28;

/// Throws `UsageError` unless `text` is WxH with 1 to 65536 pixels a side and at most 2^28.
ImageSize parse_size(const std::string& text);

/// The camera that the options ask for, else the scene's own. Throws `UsageError` for a camera that
/// is not there, or a view that cannot be read.
Camera camera_of(const SceneFile& file, const ViewOptions& options, const ImageSize& size);

}  // namespace raycat::app
