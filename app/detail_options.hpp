#pragma once

#include <optional>
#include <string>

#include "categories/detail.hpp"
#include "tracer/scene.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace raycat::app {

/// The lights that categories tell of.
enum class LightDetail { on, off, visible };

/// What categories keep of a ray tree: the options that `render`, `probe` and `compare` share.
struct DetailOptions {
  Detail detail;  ///< all but its lights and paths
  LightDetail lights = LightDetail::on;
  std::optional<std::string> paths;
  bool mark_textures = true;
};

void add_detail(CLI::App& command, DetailOptions& options);

/// Which lights count in ray trees.
CountedLights counted_lights(const DetailOptions& options);

/// The detail that the options ask for of `scene`, whose names the path expression may use. Throws
/// `UsageError`, with the place in the expression, for one that cannot be read.
Detail detail_for(const DetailOptions& options, const Scene& scene);

}  // namespace raycat::app
