#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/render_options.hpp"
#include "app/rendered.hpp"

namespace raycat::app {

struct Seconds {
  double load = 0.0;
  double build = 0.0;
  double trace = 0.0;
  double edges = 0.0;
  double antialias = 0.0;
  double write = 0.0;
};

/// What --stats and --json say of a render.
nlohmann::ordered_json stats_of(const RenderOptions& options, const SceneFile& file,
                                const Rendered& rendered, const Seconds& seconds);

}  // namespace raycat::app
