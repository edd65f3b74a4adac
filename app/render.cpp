#include "categories/render.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/progress_bar.hpp"
#include "app/report.hpp"
#include "app/view.hpp"
#include "edges/edge_map.hpp"
#include "edges/paint.hpp"
#include "io/image_file.hpp"
#include "io/output_file.hpp"

namespace raycat::app {
namespace {

enum class Method { heap, none };

struct RenderOptions {
  CommonOptions common;
  ViewOptions view;
  Method method = Method::heap;
  Detail detail;
  std::string out;
  std::string edges;
  std::string overlay;
  std::string lines;
  std::string segments;
  std::string stats;
};

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

// The command that makes the same picture: what shapes it, and nothing of where it goes or how
// many threads make it, so that the files do not depend on these.
std::string command_of(const RenderOptions& options, const CLI::App& command) {
  static const std::vector<std::string> left_out{"SCENE",      "--threads", "--quiet",   "--json",
                                                 "--out",      "--edges",   "--overlay", "--lines",
                                                 "--segments", "--stats"};
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

struct Seconds {
  double load = 0.0;
  double build = 0.0;
  double trace = 0.0;
  double edges = 0.0;
  double write = 0.0;
};

nlohmann::ordered_json stats_of(const RenderOptions& options, const SceneFile& file,
                                const ImageSize& size, const Rendering* categorized,
                                std::size_t edge_pixels, const RayCounts& rays,
                                const Seconds& seconds) {
  const auto pixels = static_cast<double>(size.width) * size.height;
  nlohmann::ordered_json stats{{"scene", options.common.scene},
                               {"width", size.width},
                               {"height", size.height},
                               {"threads", options.common.threads}};
  if (categorized != nullptr) {
    static const char* const granularity[] = {"object", "primitive", "face"};
    stats["categories"] = {{"method", "heap"},
                           {"ids", granularity[static_cast<int>(options.detail.ids)]},
                           {"levels", categorized->extent.levels},
                           {"lights", options.detail.lights},
                           {"distinct", categorized->categories.table.size()},
                           {"textured_pixels", categorized->textured_pixels},
                           {"overflowed_pixels", 0},
                           {"bytes", categorized->categories.bytes()}};
    stats["edges"] = {{"pixels", edge_pixels},
                      {"fraction", static_cast<double>(edge_pixels) / pixels}};
  } else {
    stats["categories"] = {{"method", "none"}};
  }
  const auto colour = static_cast<std::uint64_t>(pixels);
  stats["samples"] = {{"colour", colour},
                      {"category_only", rays.camera - colour},
                      {"per_pixel", static_cast<double>(rays.camera) / pixels}};
  stats["rays"] = {{"camera", rays.camera},
                   {"reflection", rays.reflection},
                   {"refraction", rays.refraction},
                   {"shadow", rays.shadow}};
  stats["seconds"] = {{"load", seconds.load},   {"build", seconds.build}, {"trace", seconds.trace},
                      {"edges", seconds.edges}, {"antialias", 0.0},       {"write", seconds.write}};
  stats["peak_memory_bytes"] = peak_memory();
  stats["warnings"] = file.warnings;
  return stats;
}

// Every file that the options name, as given.
std::vector<std::string> image_outputs(const RenderOptions& options) {
  std::vector<std::string> paths;
  for (const std::string* path :
       {&options.out, &options.edges, &options.overlay, &options.lines, &options.segments}) {
    if (!path->empty()) {
      paths.push_back(*path);
    }
  }
  return paths;
}

// Finds out before the work what would go wrong after it: two outputs in one file, an output in
// place of the scene, and files that cannot be written.
void require_outputs(const RenderOptions& options) {
  std::vector<std::string> paths = image_outputs(options);
  if (paths.empty() && options.stats.empty() && !options.common.json) {
    throw UsageError("render: nothing to write: give -o OUT.png or another output");
  }
  if (options.method == Method::none && !paths.empty() && paths != std::vector{options.out}) {
    throw UsageError("--method none makes no edges, overlay, lines or segments");
  }
  for (const std::string& path : paths) {
    require_image_path(path);
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

void render(const RenderOptions& options, const CLI::App& command) {
  const ImageSize size = parse_size(options.view.size);
  require_outputs(options);
  Stopwatch watch;
  Seconds seconds;
  SceneFile file = load(options.common);
  const Camera camera = choose_camera(file, options.view, size);
  add_default_lights(file.scene, camera);
  seconds.load = watch.lap();
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  const Accel accel(file.scene);
  seconds.build = watch.lap();

  RayCounts rays;
  std::optional<Rendering> categorized;
  Image colour(0, 0);
  {
    ProgressBar bar(options.common.scene, options.common.quiet);
    const RenderSettings settings{.width = size.width,
                                  .height = size.height,
                                  .levels = options.view.levels,
                                  .threads = options.common.threads,
                                  .detail = options.detail,
                                  .progress = bar.callback()};
    if (options.method == Method::none) {
      colour = render_colour(accel, camera, settings, rays);
    } else {
      categorized = raycat::render(accel, camera, settings);
      rays = categorized->rays;
    }
  }
  seconds.trace = watch.lap();
  const Image& picture = categorized ? categorized->colour : colour;
  const EdgeMap edges = categorized ? detect_edges(categorized->categories) : EdgeMap{};
  seconds.edges = watch.lap();

  const Provenance provenance{.command = command_of(options, command),
                              .scene = options.common.scene};
  const InterruptDelay delay;
  const auto write = [&](const std::string& path, const auto& make) {
    if (!path.empty()) {
      write_image(path, make(), provenance);
    }
  };
  write(options.out, [&]() -> const Image& { return picture; });
  write(options.edges, [&] { return edge_image(edges); });
  write(options.overlay, [&] { return overlay_image(picture, edges); });
  write(options.lines, [&] { return line_image(edges); });
  write(options.segments, [&] { return segment_image(categorized->categories); });
  seconds.write = watch.lap();

  const nlohmann::ordered_json stats = stats_of(
      options, file, size, categorized ? &*categorized : nullptr, edges.count(), rays, seconds);
  if (!options.stats.empty()) {
    write_file(options.stats, dump(stats, 2) + "\n");
  }
  if (options.common.json) {
    print(dump(stats));
  }
}

}  // namespace

void add_render(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand(
      "render", "Render a scene: its picture, and edges, lines and segments from its categories");
  add_common(*command, options->common);
  add_view(*command, options->view);
  command->add_option("-o,--out", options->out, "The picture: .png, .exr or .ppm")
      ->type_name("FILE");
  add_choice<Method>(*command, "--method", options->method,
                     {{"heap", Method::heap}, {"none", Method::none}},
                     "Category encoding: heap (default) or none")
      ->type_name("METHOD");
  add_choice<Granularity>(
      *command, "--ids", options->detail.ids,
      {{"object", Granularity::object},
       {"primitive", Granularity::primitive},
       {"face", Granularity::face}},
      "What counts as a surface of its own: object, primitive or face (default)")
      ->type_name("IDS");
  command
      ->add_option("--category-levels", options->detail.levels,
                   "Levels of the ray tree that categories keep; all by default")
      ->type_name("N")
      ->check(CLI::Range(1, most_levels));
  add_choice<bool>(*command, "--lights", options->detail.lights, {{"on", true}, {"off", false}},
                   "Do categories tell which lights are visible: on (default) or off")
      ->type_name("on|off");
  command
      ->add_option("--min-weight", options->detail.min_weight,
                   "Categories drop nodes that count for less than this in the pixel")
      ->type_name("W")
      ->check(number_in(0.0, 1.0));
  command->add_option("--edges", options->edges, "Edge map, white on black")->type_name("FILE");
  command->add_option("--overlay", options->overlay, "The picture with its edges in black")
      ->type_name("FILE");
  command->add_option("--lines", options->lines, "Line art, black on white")->type_name("FILE");
  command->add_option("--segments", options->segments, "A colour for each category")
      ->type_name("FILE");
  command->add_option("--stats", options->stats, "Figures about the render")->type_name("F.json");
  command->callback([options, command] { render(*options, *command); });
}

}  // namespace raycat::app
