#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/rendered.hpp"
#include "io/images/image_file.hpp"
#include "render/view_as.hpp"

namespace raycat::app {

/// A picture or map that `raycat render` writes into a file of its own. A new one is a row of the
/// table in render_outputs.cpp.
struct RenderOutput {
  /// What it is made from. Maps of trees are maps of categories too, but of the heap method alone.
  enum class From { picture, categories, trees, coverage };

  std::string_view option;  ///< that asks for it: `--edges`; its file name follows
  std::string_view help;
  From from = From::categories;

  /// Throws `std::invalid_argument` for a name that its kind of file does not have.
  void (*require_path)(const std::filesystem::path& path) = nullptr;

  /// Finds what it shows, where more than edges and categories is needed; else null.
  void (*find)(const SurfaceTable& surfaces, Rendered& rendered) = nullptr;

  void (*write)(const std::filesystem::path& path, Rendered& rendered,
                const Provenance& provenance) = nullptr;
};

/// An output and the file that it is to be in.
struct WantedOutput {
  const RenderOutput* output = nullptr;
  std::string path;
};

/// Those with an option of their own, in the order in which `--help` lists them.
std::span<const RenderOutput> render_outputs();

/// What `--view-as` asks for, in false colours.
const RenderOutput& view_output(View view);

/// Is the output of this option among them?
bool holds(std::span<const WantedOutput> wanted, std::string_view option);

/// Does any of these come of categories, or of their trees?
bool need_categories(std::span<const WantedOutput> wanted);

}  // namespace raycat::app
