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
#include "io/images/image_file.hpp"
#include "io/images/indexed_png.hpp"
#include "io/images/layer_file.hpp"
#include "render/edge_class_palette.hpp"
#include "render/paint.hpp"
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

// The maps that are asked for.
void find_edges(const RenderOptions& options, const Accel& accel, const Camera& camera,
                const RenderSettings& settings, Rendered& rendered) {
  Rendering& rendering = *rendered.categorized;
  rendered.edges = detect_edges(rendering.categories);
  rendered.selected = selected_pixels(rendered.edges, rendering.categories);
  if (!options.edge_classes.empty()) {
    rendered.classes = classify_edges(rendering.categories, rendering.encoder,
                                      accel.scene().surfaces, settings.detail.ids);
  }
  if (!options.regions.empty()) {
    rendered.regions = connected_regions(rendering.categories);
  }
  rendered.rays = rendering.rays;
  if (options.subpixel > 0) {
    CategoryTable table(rendering.categories.table);  // that of the pixels stays as it is
    const auto sample = [&](std::span<const glm::dvec2> lattice) {
      std::vector<glm::dvec2> points(lattice.begin(), lattice.end());
      for (glm::dvec2& point : points) {
        point += 0.5;  // from the lattice, which goes through the centres of pixels, to the image
      }
      return categorize(accel, camera, settings, points, rendering.encoder, table, rendered.rays);
    };
    rendered.refined = refine_edges(rendering.categories, options.subpixel, sample);
  }
}

// The picture does not depend on the level of detail of the maps; its coverage does.
void smooth_picture(const RenderOptions& options, const Accel& accel, const Camera& camera,
                    const RenderSettings& settings, Rendered& rendered) {
  ProgressBar bar(options.common.scene, options.common.quiet);
  SceneSampler sampler(accel, camera, settings.width, settings.height, settings.levels,
                       settings.threads, options.alpha ? Backdrop::transparent : Backdrop::shown);
  rendered.smooth = smooth(sampler,
                           {.width = settings.width,
                            .height = settings.height,
                            .threads = settings.threads,
                            .coverage = !options.coverage.empty(),
                            .progress = bar.callback()},
                           *smoothing(options));
  rendered.colour = Image(settings.width, settings.height);
  rendered.colour.pixels = rendered.smooth->without_alpha();
  if (options.alpha) {
    for (const glm::vec4& pixel : rendered.smooth->colour) {
      rendered.colour.alpha.push_back(pixel.a);
    }
  }
  rendered.rays += sampler.rays();
  if (!options.coverage.empty()) {
    rendered.coverage = coverage_image(
        *rendered.smooth, [&](TreeId id) -> const RayTree& { return sampler.tree(id); },
        accel.scene().surfaces, settings.detail, options.ranks);
  }
}

std::vector<Layer> layers_of(const CoverageImage& coverage) {
  const auto ranks = static_cast<std::size_t>(coverage.ranks);
  const auto every = [&](const auto& values, std::size_t rank) {
    std::decay_t<decltype(values)> out;
    for (std::size_t i = rank; i < values.size(); i += ranks) {
      out.push_back(values[i]);
    }
    return out;
  };
  std::vector<Layer> layers;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    layers.push_back({.name = fmt::format("id{}", rank), .values = every(coverage.ids, rank)});
    layers.push_back(
        {.name = fmt::format("coverage{}", rank), .values = every(coverage.shares, rank)});
  }
  return layers;
}

void write_outputs(const RenderOptions& options, const Rendered& rendered,
                   const Provenance& provenance) {
  const auto write = [&](const std::string& path, const auto& make) {
    if (!path.empty()) {
      write_image(path, make(), provenance);
    }
  };
  const auto write_view = [&](const std::string& path, View view) {
    const Rendering& rendering = *rendered.categorized;
    const ViewImage shown = view_image(rendering.categories, rendering.encoder, view);
    write_image(path, shown.image,
                {.command = fmt::format("{} --view-as {}", provenance.command, name(view)),
                 .scene = provenance.scene,
                 .legend = shown.legend});
  };
  const EdgeMap& edges = rendered.refined ? rendered.refined->map : rendered.edges;
  if (options.view_as) {
    write_view(options.out, *options.view_as);
  } else {
    write(options.out, [&]() -> const Image& { return rendered.picture(); });
  }
  write(options.edges, [&] { return edge_image(edges); });
  write(options.overlay, [&] { return overlay_image(rendered.picture(), rendered.edges); });
  write(options.lines, [&] { return line_image(edges); });
  write(options.selected, [&] { return edge_image(rendered.selected); });
  write(options.segments, [&] { return segment_image(rendered.categorized->categories); });
  write(options.regions,
        [&] { return region_image(rendered.categorized->categories, *rendered.regions); });
  for (const auto& [view, path] : options.views) {
    write_view(path, view);
  }
  if (rendered.coverage) {
    write_layers(options.coverage, rendered.coverage->width, rendered.coverage->height,
                 layers_of(*rendered.coverage), provenance);
  }
  if (rendered.classes) {
    write_indexed_png(
        options.edge_classes,
        {.width = rendered.classes->width,
         .height = rendered.classes->height,
         .pixels = rendered.classes->masks},
        edge_class_palette(),
        {.command = provenance.command, .scene = provenance.scene, .legend = edge_class_legend()});
  }
}

void render(const RenderOptions& options, const CLI::App& command) {
  const ImageSize size = parse_size(options.view.size);
  require_outputs(options, size);
  Stopwatch watch;
  Seconds seconds;
  SceneFile file = load(options.common);
  const Camera camera = lit_view(file, options.view, size);
  RenderSettings settings = settings_of(options, size, file.scene);
  seconds.load = watch.lap();
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  const Accel accel(file.scene);
  seconds.build = watch.lap();

  Rendered rendered;
  {
    ProgressBar bar(options.common.scene, options.common.quiet);
    settings.progress = bar.callback();
    if (smoothing(options) ? wants_categories(options) : options.method.has_value()) {
      rendered.categorized = raycat::render(accel, camera, settings);
    } else if (!smoothing(options)) {
      rendered.colour = render_colour(accel, camera, settings, rendered.rays);
    }
  }
  seconds.trace = watch.lap();
  if (rendered.categorized) {
    find_edges(options, accel, camera, settings, rendered);
  }
  seconds.edges = watch.lap();
  if (smoothing(options)) {
    smooth_picture(options, accel, camera, settings, rendered);
  }
  seconds.antialias = watch.lap();

  const InterruptDelay delay;
  write_outputs(options, rendered,
                {.command = reproducing_command(options, command), .scene = options.common.scene});
  seconds.write = watch.lap();
  const nlohmann::ordered_json stats = stats_of(options, file, rendered, seconds);
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
