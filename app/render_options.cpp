#include "app/render_options.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/command.hpp"
#include "app/help.hpp"
#include "edges/refine.hpp"
#include "io/files/output_file.hpp"
#include "io/images/image_file.hpp"

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
      options.outputs.push_back({&view_output(view), text.substr(equals + 1)});
    } else if (options.view_as) {
      throw CLI::ValidationError("--view-as", "the picture shows one view: use KIND=FILE");
    } else {
      options.view_as = view;
    }
    return;
  }
  throw CLI::ValidationError("--view-as", fmt::format("'{}' is not one of {}", kind, kinds));
}

// That of the picture, or of the view in its place; empty if neither is wanted.
std::string picture_path(const RenderOptions& options) {
  for (const WantedOutput& each : options.outputs) {
    if (each.output->from == RenderOutput::From::picture) {
      return each.path;
    }
  }
  return "";
}

void require_method(const RenderOptions& options, std::span<const WantedOutput> wanted) {
  if (!options.method) {
    if (need_categories(wanted)) {
      throw UsageError("--method none makes no edges, segments or other maps of categories");
    }
    if (options.detail.paths || options.subpixel > 0) {
      throw UsageError("--method none makes no categories, which --paths and --subpixel are for");
    }
    return;
  }
  for (const auto& [output, path] : wanted) {
    if (*options.method != Method::heap && output->from == RenderOutput::From::trees) {
      throw UsageError(
          fmt::format("--method {}: {} needs the trees, which only heap categories hold",
                      name(*options.method), output->option));
    }
  }
}

// Options that have no use without others.
void require_company(const RenderOptions& options, std::span<const WantedOutput> wanted) {
  const bool figures = !options.stats.empty() || options.common.json;
  if (options.subpixel > 0 && !holds(wanted, "--edges") && !holds(wanted, "--lines") && !figures) {
    throw UsageError("--subpixel: give --edges or --lines, which it refines");
  }
  const std::string picture = picture_path(options);
  if (options.view_as && picture.empty()) {
    throw UsageError(fmt::format("--view-as {0}: give -o OUT.png or --view-as {0}=FILE",
                                 name(*options.view_as)));
  }
  if (options.alpha && (picture.empty() || options.view_as || !holds_alpha(picture))) {
    throw UsageError("--alpha: give -o OUT.png or OUT.exr for the picture, which is to have it");
  }
  if (holds(wanted, "--coverage") && options.antialias.method != AntialiasMethod::uniform &&
      options.antialias.method != AntialiasMethod::adaptive) {
    throw UsageError("--coverage: give --aa uniform or --aa adaptive, which know it");
  }
  if (wanted.empty() && !figures) {
    throw UsageError("render: nothing to write: give -o OUT.png or another output");
  }
}

void require_size(const RenderOptions& options, const ImageSize& size) {
  const long long width = static_cast<long long>(size.width) << options.subpixel;
  const long long height = static_cast<long long>(size.height) << options.subpixel;
  if (width > most_image_side || height > most_image_side || width * height > most_pixels) {
    throw UsageError(fmt::format(
        "--subpixel {}: the edge map would have {}x{} pixels; an image has at most {}, {} a side",
        options.subpixel, width, height, most_pixels, most_image_side));
  }
}

// Each output has a file of its own, that can be written and is not the scene.
void require_files(const RenderOptions& options, std::span<const WantedOutput> wanted) {
  std::vector<std::string> paths;
  for (const auto& [output, path] : wanted) {
    output->require_path(path);
    paths.push_back(path);
  }
  if (!options.stats.empty()) {
    paths.push_back(options.stats);
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

// Options that say where what is made goes, or who makes it.
bool shapes_nothing(const std::string& option) {
  constexpr std::array<std::string_view, 7> known{"SCENE",     "--threads", "--quiet", "--json",
                                                  "--view-as", "--ranks",   "--stats"};
  return std::ranges::find(known, option) != known.end() ||
         std::ranges::any_of(render_outputs(),
                             [&](const RenderOutput& output) { return output.option == option; });
}

}  // namespace

void add_render_options(CLI::App& command, RenderOptions& options) {
  add_common(command, options.common);
  add_view(command, options.view);
  start_group(command, groups::categories);
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
  for (const RenderOutput& output : render_outputs()) {
    const bool picture = output.from == RenderOutput::From::picture;
    command
        .add_option_function<std::string>((picture ? "-o," : "") + std::string(output.option),
                                          [&options, &output](const std::string& path) {
                                            options.outputs.push_back({&output, path});
                                          },
                                          std::string(output.help))
        ->type_name("FILE")
        ->group(picture ? groups::picture : groups::maps);
  }
  add_antialias(command, options.antialias);
  command.add_flag("--alpha", options.alpha,
                   "The background is transparent: alpha in the picture, .png or .exr");
  start_group(command, groups::maps);
  command
      .add_option("--subpixel", options.subpixel,
                  "Break edge pixels of --edges and --lines into 2^N by 2^N subpixels")
      ->type_name("N")
      ->check(CLI::Range(0, most_subpixel_levels));
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
  command.add_option("--ranks", options.ranks, "Categories a pixel of --coverage; 6 by default")
      ->type_name("K")
      ->check(CLI::Range(1, 64));
  command.add_option("--stats", options.stats, "Figures about the render, as JSON")
      ->type_name("FILE");
  command.footer(
      "Examples:\n"
      "  raycat render part.csg -o part.png --lines part-lines.png\n"
      "  raycat render room.gltf --size 1920x1080 --aa adaptive -o room.png --overlay edges.png\n"
      "  raycat render room.gltf --ids object --lights off --category-levels 1 --segments "
      "objects.png");
}

std::vector<WantedOutput> wanted_outputs(const RenderOptions& options) {
  std::vector<WantedOutput> wanted = options.outputs;
  for (WantedOutput& each : wanted) {
    if (options.view_as && each.output->from == RenderOutput::From::picture) {
      each.output = &view_output(*options.view_as);
    }
  }
  return wanted;
}

void require_outputs(const RenderOptions& options, const ImageSize& size) {
  const std::vector<WantedOutput> wanted = wanted_outputs(options);
  require_antialias(options.antialias);
  require_method(options, wanted);
  require_company(options, wanted);
  require_size(options, size);
  require_files(options, wanted);
}

std::optional<AntialiasOptions> antialiasing(const RenderOptions& options) {
  if (options.antialias.method) {
    return options.antialias;
  }
  // The one sample that others take too, but which knows what is background.
  return options.alpha
             ? std::optional(AntialiasOptions{.method = AntialiasMethod::uniform, .samples = 1})
             : std::nullopt;
}

bool wants_categories(const RenderOptions& options) {
  return options.method && (need_categories(wanted_outputs(options)) || !options.stats.empty() ||
                            options.common.json);
}

std::string reproducing_command(const RenderOptions& options, const CLI::App& command) {
  std::string text = "raycat render " + quoted(options.common.scene);
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && !shapes_nothing(name)) {
      text += " " + name;
      for (const std::string& value : option->results()) {
        text += option->get_expected_max() > 0 ? " " + quoted(value) : "";
      }
    }
  }
  return text;
}

}  // namespace raycat::app
