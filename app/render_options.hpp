#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/antialias_options.hpp"
#include "app/detail_options.hpp"
#include "app/options.hpp"
#include "app/view.hpp"
#include "categories/encoder.hpp"
#include "render/view_as.hpp"

namespace CLI {
class App;
}

namespace raycat::app {

/// What `raycat render` was asked for. Outputs that are not wanted are empty.
struct RenderOptions {
  CommonOptions common;
  ViewOptions view;
  std::optional<Method> method = Method::heap;  ///< none: no categories
  DetailOptions detail;
  int subpixel = 0;
  AntialiasOptions antialias;
  bool alpha = false;
  int ranks = 6;

  std::string out;
  std::string edges;
  std::string overlay;
  std::string lines;
  std::string edge_classes;
  std::string selected;
  std::string segments;
  std::string regions;
  std::vector<std::pair<View, std::string>> views;  ///< in files of their own
  std::optional<View> view_as;                      ///< in place of the picture
  std::string coverage;
  std::string stats;
};

void add_render_options(CLI::App& command, RenderOptions& options);

/// Finds out before the work what would go wrong after it: options that do not go together, two
/// outputs in one file, an output in place of the scene, and files that cannot be written. Throws
/// `UsageError`, or `std::runtime_error` for what the system refuses.
void require_outputs(const RenderOptions& options, const ImageSize& size);

/// How the picture is sampled by antialiasing; nothing if it is what categories are found with.
std::optional<AntialiasOptions> smoothing(const RenderOptions& options);

/// Is anything wanted that comes of categories, or of what they are?
bool wants_categories(const RenderOptions& options);

/// The command that makes the same maps: what shapes them all, and nothing of where they go or how
/// many threads make them, so that the files do not depend on these.
std::string reproducing_command(const RenderOptions& options, const CLI::App& command);

}  // namespace raycat::app
