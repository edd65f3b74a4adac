#include "app/render_options.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/command.hpp"
#include "edges/refine.hpp"
#include "io/files/output_file.hpp"
#include "io/images/image_file.hpp"
#include "io/images/indexed_png.hpp"
#include "io/images/layer_file.hpp"

namespace raycat::app {
namespace {

// As a shell takes it.
std::string quoted(const std::string& word) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
    return word;
  }
  std::string text = "'";
  for (const char c : word) {
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return text + "'";
}

// KIND, which takes the picture's place, or KIND=FILE.
void parse_view(const std::string& text, RenderOptions& options) {
  const std::size_t equals = text.find('=');
  const std::string kind = text.substr(0, equals);
  std::string kinds;
  for (const View view : all_views) {
    if (name(view) != kind) {
      kinds += fmt::format("{}{}", kinds.empty() ? "" : ", ", name(view));
      continue;
    }
    if (equals != std::string::npos) {
      if (equals + 1 == text.size()) {
        throw CLI::ValidationError("--view-as", fmt::format("{} has no file after it", text));
      }
      options.views.emplace_back(view, text.substr(equals + 1));
    } else if (options.view_as) {
      throw CLI::ValidationError("--view-as", "the picture shows one view: use KIND=FILE");
    } else {
      options.view_as = view;
    }
    return;
  }
  throw CLI::ValidationError("--view-as", fmt::format("'{}' is not one of {}", kind, kinds));
}

// The outputs that need categories, without the palette image of edge classes.
std::vector<std::string> category_images(const RenderOptions& options) {
  std::vector<std::string> paths{options.edges,    options.overlay,  options.lines,
                                 options.selected, options.segments, options.regions};
  for (const auto& [view, path] : options.views) {
    paths.push_back(path);
  }
  std::erase(paths, "");
  return paths;
}

void require_method(const RenderOptions& options, bool makes_maps) {
  if (!options.method) {
    if (makes_maps || options.view_as) {
      throw UsageError("--method none makes no edges, segments or other maps of categories");
    }
    if (options.detail.paths || options.subpixel > 0) {
      throw UsageError("--method none makes no categories, which --paths and --subpixel are for");
    }
    return;
  }
  if (*options.method != Method::heap) {
    const bool trees = std::ranges::any_of(
        options.views, [](const auto& view) { return view.first != View::category; });
    if (!options.edge_classes.empty() || trees ||
        (options.view_as && options.view_as != View::category)) {
      throw UsageError(fmt::format(
          "--method {}: edge classes and views need the trees, which only heap categories hold",
          name(*options.method)));
    }
  }
}

}  // namespace

void add_render_options(CLI::App& command, RenderOptions& options) {
  add_common(command, options.common);
  add_view(command, options.view);
  command.add_option("-o,--out", options.out, "The picture: .png, .exr or .ppm")->type_name("FILE");
  add_choice<std::optional<Method>>(
      command, "--method", options.method,
      {{"heap", Method::heap},
       {"string", Method::string},
       {"primes", Method::primes},
       {"godel", Method::godel},
       {"none", std::nullopt}},
      "Category encoding: heap (default), string, primes, godel, or none")
      ->type_name("METHOD");
  add_detail(command, options.detail);
  add_antialias(command, options.antialias);
  command.add_flag("--alpha", options.alpha,
                   "The background is transparent: alpha in the picture, .png or .exr");
  const auto output = [&](const char* name, std::string& path, const char* help) {
    command.add_option(name, path, help)->type_name("FILE");
  };
  output("--edges", options.edges, "Edge map, white on black");
  output("--overlay", options.overlay, "The picture with its edges in black");
  output("--lines", options.lines, "Line art, black on white");
  command
      .add_option("--subpixel", options.subpixel,
                  "Break edge pixels of --edges and --lines into 2^N by 2^N subpixels")
      ->type_name("N")
      ->check(CLI::Range(0, most_subpixel_levels));
  output("--edge-classes", options.edge_classes,
         "How trees differ at each edge pixel, a bit mask: silhouette, primitive, face, shadow, in "
         "reflection, in refraction; .png with a palette");
  output("--selected", options.selected,
         "Pixels to oversample, white on black: edges, and textures if they are marked");
  output("--segments", options.segments, "A colour for each category");
  output("--regions", options.regions, "A colour for each connected region of a category");
  command
      .add_option_function<std::vector<std::string>>(
          "--view-as",
          [&options](const std::vector<std::string>& views) {
            for (const std::string& view : views) {
              parse_view(view, options);
            }
          },
          "False colours in place of the picture, or in a file: depth, nodes, lights, branch or "
          "category; may be given again")
      ->type_name("KIND[=FILE]")
      ->expected(1)
      ->take_all();
  output("--coverage", options.coverage,
         "The categories that cover most of each pixel, with --aa uniform or adaptive; .exr with "
         "channels id0, coverage0, id1 and so on");
  command.add_option("--ranks", options.ranks, "Categories a pixel of --coverage; 6 by default")
      ->type_name("K")
      ->check(CLI::Range(1, 64));
  output("--stats", options.stats, "Figures about the render");
}

void require_outputs(const RenderOptions& options, const ImageSize& size) {
  require_antialias(options.antialias);
  std::vector<std::string> paths = category_images(options);
  require_method(options, !paths.empty() || !options.edge_classes.empty());
  if (options.subpixel > 0 && options.edges.empty() && options.lines.empty() &&
      options.stats.empty() && !options.common.json) {
    throw UsageError("--subpixel: give --edges or --lines, which it refines");
  }
  if (options.view_as && options.out.empty()) {
    throw UsageError(fmt::format("--view-as {0}: give -o OUT.png or --view-as {0}=FILE",
                                 name(*options.view_as)));
  }
  if (!options.out.empty()) {
    paths.push_back(options.out);
  }
  if (options.alpha && (options.out.empty() || options.view_as || !holds_alpha(options.out))) {
    throw UsageError("--alpha: give -o OUT.png or OUT.exr for the picture, which is to have it");
  }
  for (const std::string& path : paths) {
    require_image_path(path);
  }
  if (!options.edge_classes.empty()) {
    require_indexed_path(options.edge_classes);
    paths.push_back(options.edge_classes);
  }
  if (!options.coverage.empty()) {
    if (options.antialias.method != Smoothing::uniform &&
        options.antialias.method != Smoothing::adaptive) {
      throw UsageError("--coverage: give --aa uniform or --aa adaptive, which know it");
    }
    require_layer_path(options.coverage);
    paths.push_back(options.coverage);
  }
  if (!options.stats.empty()) {
    paths.push_back(options.stats);
  }
  if (paths.empty() && !options.common.json) {
    throw UsageError("render: nothing to write: give -o OUT.png or another output");
  }
  const long long width = static_cast<long long>(size.width) << options.subpixel;
  const long long height = static_cast<long long>(size.height) << options.subpixel;
  if (width > most_side || height > most_side || width * height > most_pixels) {
    throw UsageError(fmt::format(
        "--subpixel {}: the edge map would have {}x{} pixels; an image has at most {}, {} a side",
        options.subpixel, width, height, most_pixels, most_side));
  }
  std::set<std::filesystem::path> taken;
  std::error_code ignored;
  const auto place = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored);
  };
  for (const std::string& path : paths) {
    const bool device = std::filesystem::is_character_file(path, ignored);
    if (place(path) == place(options.common.scene)) {
      throw UsageError(fmt::format("{}: the output would overwrite the scene", path));
    }
    if (!device && !taken.insert(place(path)).second) {
      throw UsageError(fmt::format("{}: two outputs would go to this file", path));
    }
    require_writable(path);
  }
}

std::optional<AntialiasOptions> smoothing(const RenderOptions& options) {
  if (options.antialias.method) {
    return options.antialias;
  }
  // The one sample that others take too, but which knows what is background.
  return options.alpha ? std::optional(AntialiasOptions{.method = Smoothing::uniform, .samples = 1})
                       : std::nullopt;
}

bool wants_categories(const RenderOptions& options) {
  return options.method && (!category_images(options).empty() || !options.edge_classes.empty() ||
                            options.view_as || !options.stats.empty() || options.common.json);
}

std::string reproducing_command(const RenderOptions& options, const CLI::App& command) {
  static const std::vector<std::string> left_out{
      "SCENE",     "--threads",  "--quiet",    "--json",     "--out",     "--edges",
      "--overlay", "--lines",    "--selected", "--segments", "--regions", "--edge-classes",
      "--view-as", "--coverage", "--ranks",    "--stats"};
  std::string text = "raycat render " + quoted(options.common.scene);
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && std::ranges::find(left_out, name) == left_out.end()) {
      text += " " + name;
      for (const std::string& value : option->results()) {
        text += option->get_expected_max() > 0 ? " " + quoted(value) : "";
      }
    }
  }
  return text;
}

}  // namespace raycat::app
