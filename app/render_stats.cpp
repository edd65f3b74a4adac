#include "app/render_stats.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/report.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

std::uint64_t overflowed_pixels(const Rendering& rendering) {
  return count_pixels(rendering.categories,
                      [&](auto words) { return overflowed(*rendering.categories.encoder, words); });
}

Json categories_of(const RenderOptions& options, const Rendering& rendering) {
  static const char* const granularity[] = {"object", "primitive", "face"};
  const Detail& detail = options.detail.detail;
  return {{"method", name(*options.method)},
          {"ids", granularity[static_cast<int>(detail.ids)]},
          {"levels", std::min(options.view.levels, detail.levels)},
          {"lights", options.detail.lights != LightDetail::off},
          {"distinct", rendering.categories.table.size()},
          {"textured_pixels", textured_pixels(rendering.categories)},
          {"overflowed_pixels", overflowed_pixels(rendering)},
          {"bytes", rendering.categories.bytes()}};
}

Json edges_of(const Rendered& rendered, double pixels) {
  const std::size_t edge_pixels = rendered.edges.count();
  Json edges{{"pixels", edge_pixels},
             {"fraction", static_cast<double>(edge_pixels) / pixels},
             {"selected", rendered.selected.count()}};
  if (rendered.classes) {
    const auto counts = rendered.classes->counts();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      edges["classes"][std::string(name(all_edge_classes[i]))] = counts[i];
    }
  }
  if (rendered.refined) {
    const EdgeMap& map = rendered.refined->map;
    edges["subpixels"] = {{"width", map.width},
                          {"height", map.height},
                          {"pixels", map.count()},
                          {"sampled", rendered.refined->sampled}};
  }
  return edges;
}

// Of the picture: all else has been for categories alone.
Json samples_of(const Rendered& rendered, double pixels) {
  const std::uint64_t colour = rendered.antialiased ? rendered.antialiased->samples.colour
                                                    : static_cast<std::uint64_t>(pixels);
  Json samples{{"colour", colour},
               {"category_only", rendered.rays.camera - colour},
               {"per_pixel", static_cast<double>(rendered.rays.camera) / pixels}};
  if (rendered.antialiased) {
    samples["picture_per_pixel"] =
        static_cast<double>(colour + rendered.antialiased->samples.category_only) / pixels;
    samples["refined_pixels"] = rendered.antialiased->refined;
  }
  return samples;
}

Json parts_of(std::vector<std::uint64_t> sizes) {
  std::erase(sizes, 0u);
  std::ranges::sort(sizes, std::greater());
  return {{"count", sizes.size()}, {"sizes", sizes}};
}

}  // namespace

nlohmann::ordered_json stats_of(const RenderOptions& options, const SceneFile& file,
                                const Rendered& rendered, const Seconds& seconds) {
  const Image& picture = rendered.picture();
  const auto pixels = static_cast<double>(picture.width) * picture.height;
  const RayCounts& rays = rendered.rays;
  Json stats{{"scene", options.common.scene},
             {"width", picture.width},
             {"height", picture.height},
             {"threads", options.common.threads}};
  if (rendered.categorized) {
    stats["categories"] = categories_of(options, *rendered.categorized);
    stats["edges"] = edges_of(rendered, pixels);
    if (holds(options.outputs, "--segments")) {
      stats["segments"] = parts_of(pixels_per_category(rendered.categorized->categories));
    }
    if (rendered.regions) {
      stats["regions"] = parts_of(rendered.regions->sizes);
    }
  } else {
    stats["categories"] = {{"method", "none"}};
  }
  stats["samples"] = samples_of(rendered, pixels);
  stats["rays"] = {{"camera", rays.camera},
                   {"reflection", rays.reflection},
                   {"refraction", rays.refraction},
                   {"shadow", rays.shadow}};
  stats["seconds"] = {{"load", seconds.load},           {"build", seconds.build},
                      {"trace", seconds.trace},         {"edges", seconds.edges},
                      {"antialias", seconds.antialias}, {"write", seconds.write}};
  if (file.seconds) {
    stats["load"] = {{"parse", file.seconds->parse},
                     {"decompress", file.seconds->decompress},
                     {"images", file.seconds->images},
                     {"meshes", file.seconds->meshes},
                     {"faces", file.seconds->faces}};
  }
  stats["peak_memory_bytes"] = peak_memory();
  stats["warnings"] = file.warnings;
  return stats;
}

}  // namespace raycat::app
