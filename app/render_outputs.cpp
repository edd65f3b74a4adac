#include "app/render_outputs.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/images/indexed_png.hpp"
#include "io/images/layer_file.hpp"
#include "render/edge_class_palette.hpp"
#include "render/paint.hpp"

namespace raycat::app {
namespace {

using From = RenderOutput::From;
using Path = std::filesystem::path;

void write_classes(const Path& path, Rendered& rendered, const Provenance& provenance) {
  const EdgeClasses& classes = *rendered.classes;
  write_indexed_png(
      path, {.width = classes.width, .height = classes.height, .pixels = classes.masks},
      edge_class_palette(),
      {.command = provenance.command, .scene = provenance.scene, .legend = edge_class_legend()});
}

// An image that needs no more than what has been found.
template <auto make>
void write_made(const Path& path, Rendered& rendered, const Provenance& provenance) {
  write_image(path, make(rendered), provenance);
}

template <View view>
void write_view(const Path& path, Rendered& rendered, const Provenance& provenance) {
  const ViewImage shown = view_image(*rendered.trees, view);
  write_image(path, shown.image,
              {.command = fmt::format("{} --view-as {}", provenance.command, name(view)),
               .scene = provenance.scene,
               .legend = shown.legend});
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

void write_coverage(const Path& path, Rendered& rendered, const Provenance& provenance) {
  const CoverageImage& coverage = *rendered.coverage;
  write_layers(path, coverage.width, coverage.height, layers_of(coverage), provenance);
}

// The picture is the first.
constexpr std::array outputs{
    RenderOutput{.option = "--out",
                 .help = "The picture: .png, .exr or .ppm",
                 .from = From::picture,
                 .require_path = require_image_path,
                 .write = write_made<[](const Rendered& rendered) { return rendered.picture(); }>},
    RenderOutput{.option = "--lines",
                 .help = "Line art, black on white",
                 .require_path = require_image_path,
                 .write = write_made<[](const Rendered& rendered) {
                   return line_image(rendered.finest_edges());
                 }>},
    RenderOutput{.option = "--overlay",
                 .help = "The picture with its edges in black",
                 .require_path = require_image_path,
                 .write = write_made<[](const Rendered& rendered) {
                   return overlay_image(rendered.picture(), rendered.edges);
                 }>},
    RenderOutput{.option = "--edges",
                 .help = "Edge map, white on black",
                 .require_path = require_image_path,
                 .write = write_made<[](const Rendered& rendered) {
                   return edge_image(rendered.finest_edges());
                 }>},
    RenderOutput{.option = "--segments",
                 .help = "A colour for each category",
                 .require_path = require_image_path,
                 .write = write_made<[](const Rendered& rendered) {
                   return segment_image(rendered.categories());
                 }>},
    RenderOutput{.option = "--regions",
                 .help = "A colour for each connected region of a category",
                 .require_path = require_image_path,
                 .find =
                     [](const SurfaceTable& /*surfaces*/, Rendered& rendered) {
                       rendered.regions = connected_regions(rendered.categories());
                     },
                 .write = write_made<[](const Rendered& rendered) {
                   return region_image(rendered.categories(), *rendered.regions);
                 }>},
    RenderOutput{.option = "--edge-classes",
                 .help = "How trees differ at each edge pixel, a bit mask: silhouette, primitive, "
                         "face, shadow, in reflection, in refraction; .png with a palette",
                 .from = From::trees,
                 .require_path = require_indexed_path,
                 .find =
                     [](const SurfaceTable& surfaces, Rendered& rendered) {
                       rendered.classes = classify_edges(*rendered.trees, surfaces);
                     },
                 .write = write_classes},
    RenderOutput{
        .option = "--selected",
        .help = "Pixels to oversample, white on black: edges, and textures if they are "
                "marked",
        .require_path = require_image_path,
        .write =
            write_made<[](const Rendered& rendered) { return edge_image(rendered.selected); }>},
    RenderOutput{.option = "--coverage",
                 .help = "The categories that cover most of each pixel, with --aa uniform or "
                         "adaptive; .exr with channels id0, coverage0, id1 and so on",
                 .from = From::coverage,
                 .require_path = require_layer_path,
                 .write = write_coverage},
};

template <View view>
constexpr RenderOutput view_row{.option = "--view-as",
                                .help = {},
                                .from = view == View::category ? From::categories : From::trees,
                                .require_path = require_image_path,
                                .write = write_view<view>};

}  // namespace

std::span<const RenderOutput> render_outputs() { return outputs; }

const RenderOutput& view_output(View view) {
  switch (view) {
    case View::depth:
      return view_row<View::depth>;
    case View::nodes:
      return view_row<View::nodes>;
    case View::lights:
      return view_row<View::lights>;
    case View::branch:
      return view_row<View::branch>;
    case View::category:
      break;
  }
  return view_row<View::category>;
}

bool holds(std::span<const WantedOutput> wanted, std::string_view option) {
  return std::ranges::any_of(
      wanted, [&](const WantedOutput& each) { return each.output->option == option; });
}

bool need_categories(std::span<const WantedOutput> wanted) {
  return std::ranges::any_of(wanted, [](const WantedOutput& each) {
    return each.output->from == From::categories || each.output->from == From::trees;
  });
}

}  // namespace raycat::app
