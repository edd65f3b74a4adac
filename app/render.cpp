#include "render/render.hpp"

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/progress_bar.hpp"
#include "app/render_options.hpp"
#include "app/render_stats.hpp"
#include "app/report.hpp"
#include "io/files/output_file.hpp"
#include "raycat/scene_view.hpp"
#include "render/scene_sampler.hpp"

namespace raycat::app {
namespace {

RenderSettings settings_of(const RenderOptions& options, const ImageSize& size,
                           const Scene& scene) {
  return {.width = size.width,
          .height = size.height,
          .levels = options.view.levels,
          .threads = options.common.threads,
          .method = options.method.value_or(Method::heap),
          .detail = detail_for(options.detail, scene),
          .mark_textures = options.detail.mark_textures};
}

// What the maps that are wanted show.
void find_edges(const RenderOptions& options, std::span<const WantedOutput> wanted,
                const SceneView& view, const Camera& camera, const RenderSettings& settings,
                Rendered& rendered) {
  const CategoryImage& categories = rendered.categories();
  rendered.trees.emplace(categories);
  rendered.edges = detect_edges(categories);
  rendered.selected = selected_pixels(rendered.edges, categories);
  rendered.rays = rendered.categorized->rays;
  for (const WantedOutput& each : wanted) {
    if (each.output->find != nullptr) {
      each.output->find(view.scene().surfaces, rendered);
    }
  }
  if (options.subpixel > 0) {
    FinerSamples finer(view.accel(), camera, settings, categories);
    rendered.refined = refine_edges(categories, options.subpixel, std::ref(finer));
    rendered.rays += finer.rays();
  }
}

// Antialiases the picture, which does not depend on the level of detail of the maps; its coverage
// does.
void antialias_picture(const RenderOptions& options, SceneSampler& sampler, const SceneView& view,
                       const RenderSettings& settings, Rendered& rendered) {
  const bool wants_coverage = holds(options.outputs, "--coverage");
  ProgressBar bar(options.common.scene, options.common.quiet);
  rendered.antialiased = antialias(sampler,
                                   {.width = settings.width,
                                    .height = settings.height,
                                    .threads = settings.threads,
                                    .coverage = wants_coverage,
                                    .progress = bar.callback()},
                                   *antialiasing(options));
  rendered.colour = Image(settings.width, settings.height);
  rendered.colour.pixels = rendered.antialiased->without_alpha();
  if (options.alpha) {
    for (const glm::vec4& pixel : rendered.antialiased->colour) {
      rendered.colour.alpha.push_back(pixel.a);
    }
  }
  rendered.rays += sampler.rays();
  if (wants_coverage) {
    rendered.coverage = coverage_image(
        *rendered.antialiased, [&](TreeId id) -> const RayTree& { return sampler.tree(id); },
        view.scene().surfaces, settings.detail, options.ranks);
  }
}

// Traces the picture's samples, with their categories if these are wanted. Those that antialiasing
// will want too are kept by `sampler`.
void trace_samples(const RenderOptions& options, const SceneView& view, const Camera& camera,
                   RenderSettings settings, std::optional<SceneSampler>& sampler,
                   Rendered& rendered) {
  const bool antialiased = antialiasing(options).has_value();
  const bool categorized = antialiased ? wants_categories(options) : options.method.has_value();
  if (antialiased) {
    sampler.emplace(view.accel(), camera, settings.width, settings.height, settings.levels,
                    settings.threads, options.alpha ? Backdrop::transparent : Backdrop::shown,
                    categorized);
  }
  ProgressBar bar(options.common.scene, options.common.quiet);
  settings.progress = bar.callback();
  if (categorized) {
    rendered.categorized = sampler ? raycat::render(view.accel(), camera, settings, *sampler)
                                   : raycat::render(view.accel(), camera, settings);
  } else if (!antialiased) {
    rendered.colour = render_colour(view.accel(), camera, settings, rendered.rays);
  }
}

void render(const RenderOptions& options, const CLI::App& command) {
  const ImageSize size = parse_size(options.view.size);
  require_outputs(options, size);
  const std::vector<WantedOutput> wanted = wanted_outputs(options);
  Stopwatch watch;
  Seconds seconds;
  SceneFile file = load(options.common);
  file.scene.counted_lights = counted_lights(options.detail);
  const Camera camera = camera_of(file, options.view, size);
  seconds.load = watch.lap();
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  const SceneView view(std::move(file), camera);
  const RenderSettings settings = settings_of(options, size, view.scene());
  seconds.build = watch.lap();

  Rendered rendered;
  std::optional<SceneSampler> sampler;
  trace_samples(options, view, camera, settings, sampler, rendered);
  seconds.trace = watch.lap();
  if (rendered.categorized) {
    find_edges(options, wanted, view, camera, settings, rendered);
  }
  seconds.edges = watch.lap();
  if (sampler) {
    antialias_picture(options, *sampler, view, settings, rendered);
  }
  seconds.antialias = watch.lap();

  const InterruptDelay delay;
  const Provenance provenance{.command = reproducing_command(options, command),
                              .scene = options.common.scene};
  for (const auto& [output, path] : wanted) {
    output->write(path, rendered, provenance);
  }
  seconds.write = watch.lap();
  const nlohmann::ordered_json stats = stats_of(options, view.file(), rendered, seconds);
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
  add_render_options(*command, *options);
  command->callback([options, command] { render(*options, *command); });
}

}  // namespace raycat::app
