#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/antialias_options.hpp"
#include "app/detail_options.hpp"
#include "app/options.hpp"
#include "app/render_outputs.hpp"
#include "app/view.hpp"
#include "categories/encoder.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace raycat::app {

/// What `raycat render` was asked for.
struct RenderOptions {
  CommonOptions common;
  ViewOptions view;
  std::optional<Method> method = Method::heap;  ///< none: no categories
  DetailOptions detail;
  int subpixel = 0;
  AntialiasOptions antialias;
  bool alpha = false;
  int ranks = 6;

  std::vector<WantedOutput> outputs;  ///< as they were asked for
  std::optional<View> view_as;        ///< in place of the picture
  std::string stats;                  ///< a file for them; none if empty
};

void add_render_options(CLI::App& command, RenderOptions& options);

/// What is to be written, figures aside: `outputs`, with `view_as` in place of the picture.
std::vector<WantedOutput> wanted_outputs(const RenderOptions& options);

/// Finds out before the work what would go wrong after it: options that do not go together, two
/// outputs in one file, an output in place of the scene, and files that cannot be written. Throws
/// `UsageError`, or `std::runtime_error` for what the system refuses.
void require_outputs(const RenderOptions& options, const ImageSize& size);

/// How the picture is sampled by antialiasing; nothing if it is what categories are found with.
std::optional<AntialiasOptions> antialiasing(const RenderOptions& options);

/// Is anything wanted that comes of categories, or of what they are?
bool wants_categories(const RenderOptions& options);

/// The command that makes the same maps: what shapes them all, and nothing of where they go or how
/// many threads make them, so that the files do not depend on these.
std::string reproducing_command(const RenderOptions& options, const CLI::App& command);

}  // namespace raycat::app
