#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "antialias/antialias.hpp"
#include "app/render_options.hpp"
#include "edges/edge_classes.hpp"
#include "edges/edge_map.hpp"
#include "edges/refine.hpp"
#include "edges/regions.hpp"
#include "render/coverage.hpp"
#include "render/render.hpp"

namespace raycat::app {

struct Seconds {
  double load = 0.0;
  double build = 0.0;
  double trace = 0.0;
  double edges = 0.0;
  double antialias = 0.0;
  double write = 0.0;
};

/// All that `raycat render` makes, before it is written.
struct Rendered {
  std::optional<Rendering> categorized;  ///< or without categories:
  Image colour{0, 0};
  std::optional<SmoothPicture> smooth;  ///< of the picture, if it is antialiased: then in `colour`
  std::optional<CoverageImage> coverage;
  RayCounts rays;

  EdgeMap edges;
  EdgeMap selected;
  std::optional<RefinedEdges> refined;
  std::optional<EdgeClasses> classes;
  std::optional<Regions> regions;

  const Image& picture() const { return categorized && !smooth ? categorized->colour : colour; }
};

/// What --stats and --json say of a render.
nlohmann::ordered_json stats_of(const RenderOptions& options, const SceneFile& file,
                                const Rendered& rendered, const Seconds& seconds);

}  // namespace raycat::app
