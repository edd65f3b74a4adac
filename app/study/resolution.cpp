#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study/study.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int smallest = 64;
constexpr int deepest = 6;

struct Point {
  int size;
  std::uint64_t edge_pixels;
  double share;
  std::size_t categories;
};

// A level of detail of a scene at every size.
struct Curve {
  std::string scene;
  int levels;
  bool lights;
  std::vector<Point> points;
};

// Of one scene: the surfaces seen directly, and all that there is.
struct SceneCurves {
  std::vector<Curve> all;

  const Curve& surfaces() const { return all.front(); }
  const Curve& full() const { return all.back(); }
};

SceneCurves measure(const StudySettings& settings, const std::string& name) {
  const StudyScene scene(settings, name, {.width = smallest, .height = smallest});
  SceneCurves curves;
  for (const bool lights : {false, true}) {
    for (int levels = 1; levels <= deepest; ++levels) {
      curves.all.push_back(
          {.scene = scene.label, .levels = levels, .lights = lights, .points = {}});
    }
  }
  for (int size = smallest; size <= settings.largest; size *= 2) {
    const ImageSize square{.width = size, .height = size};
    const Rendering rendering = trace(settings, scene, square, deepest);
    CategoryTrees trees(rendering.categories);
    for (Curve& curve : curves.all) {
      const CategoryImage categories = at_detail(scene, trees, curve.levels, curve.lights);
      const std::uint64_t count = edge_pixels(categories);
      curve.points.push_back({.size = size,
                              .edge_pixels = count,
                              .share = share(count, square),
                              .categories = categories.table.size()});
    }
  }
  return curves;
}

// x where the share of edge pixels falls as n^-x up to point `i` from the one before, of half its
// size; none where there is nothing to fall.
std::optional<double> exponent(const Curve& curve, std::size_t i) {
  if (i == 0 || curve.points[i - 1].edge_pixels == 0 || curve.points[i].edge_pixels == 0) {
    return std::nullopt;
  }
  return std::log2(curve.points[i - 1].share / curve.points[i].share);
}

std::optional<double> last_exponent(const Curve& curve) {
  return exponent(curve, curve.points.size() - 1);
}

std::string shown(const std::optional<double>& number) {
  return number ? fmt::format("{:.3f}", *number) : "";
}

// Edges of that length in sides of the image, each pixel of them a pixel's side long.
double length(const Point& point) { return point.share * point.size; }

void add_rows(const Curve& curve, Table& table) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point& point = curve.points[i];
    table.rows.push_back({curve.scene, std::to_string(curve.levels), curve.lights ? "on" : "off",
                          std::to_string(point.size), std::to_string(point.edge_pixels),
                          percent(point.share), shown(exponent(curve, i)),
                          fmt::format("{:.1f}", length(point)), std::to_string(point.categories)});
  }
}

void add_points(const Curve& curve, Json& points) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point& point = curve.points[i];
    const std::optional<double> fall = exponent(curve, i);
    points.push_back({{"scene", curve.scene},
                      {"levels", curve.levels},
                      {"lights", curve.lights},
                      {"size", point.size},
                      {"edge_pixels", point.edge_pixels},
                      {"edge_fraction", point.share},
                      {"exponent", fall ? Json(*fall) : Json(nullptr)},
                      {"categories", point.categories}});
  }
}

// A line for each scene and each of its two laws, of what `add` finds in a curve.
template <typename Add>
std::vector<PlotSeries> lines(const std::vector<SceneCurves>& scenes, const Add& add) {
  std::vector<PlotSeries> series;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    for (const Curve* curve : {&scenes[s].surfaces(), &scenes[s].full()}) {
      PlotSeries line{.name = fmt::format("{}, depth {} {} lights", curve->scene, curve->levels,
                                          curve->lights ? "with" : "without"),
                      .points = {},
                      .style = static_cast<int>(s),
                      .dashed = curve->lights};
      add(*curve, line.points);
      if (!line.points.empty()) {
        series.push_back(std::move(line));
      }
    }
  }
  return series;
}

// The law, through the last point of `line`.
PlotSeries hyperbola(const PlotSeries& line) {
  PlotSeries law{.name = "1/n, the paper's law", .style = 4, .dashed = true, .marked = false};
  const glm::dvec2 last = line.points.back();
  for (double step = 0.0; step <= 8.0 * std::log2(last.x / smallest); step += 1.0) {
    const double size = smallest * std::exp2(step / 8.0);
    law.points.emplace_back(size, last.y * last.x / size);
  }
  return law;
}

Plot edge_plot(const std::vector<SceneCurves>& scenes) {
  Plot plot{.title = "Fig. 12: edge pixels by resolution",
            .x = {.label = "side n of the image, pixels", .scale = AxisScale::binary},
            .y = {.label = "edge pixels, % of all", .scale = AxisScale::decimal},
            .series = lines(scenes, [](const Curve& curve, std::vector<glm::dvec2>& points) {
              for (const Point& point : curve.points) {
                if (point.edge_pixels > 0) {
                  points.emplace_back(point.size, 100.0 * point.share);
                }
              }
            })};
  if (!plot.series.empty()) {
    plot.series.push_back(hyperbola(plot.series.front()));
  }
  return plot;
}

// Axes as the paper's graph has them, and its scene.
Plot paper_plot(const SceneCurves& curves) {
  Plot plot = edge_plot({curves});
  plot.title = "Fig. 12, with the paper's axes";
  plot.x.scale = AxisScale::linear;
  plot.y.scale = AxisScale::linear;
  return plot;
}

Plot exponent_plot(const std::vector<SceneCurves>& scenes) {
  return {.title = "Fig. 12: local exponents (1 is the paper's law)",
          .x = {.label = "side n of the image, pixels", .scale = AxisScale::binary},
          .y = {.label = "x, edges falling as n^-x from n/2 to n"},
          .series = lines(scenes, [](const Curve& curve, std::vector<glm::dvec2>& points) {
            for (std::size_t i = 1; i < curve.points.size(); ++i) {
              if (const std::optional<double> x = exponent(curve, i)) {
                points.emplace_back(curve.points[i].size, *x);
              }
            }
          })};
}

Plot depth_plot(const std::vector<SceneCurves>& scenes) {
  Plot plot{.title = "Fig. 12: the last local exponent by depth",
            .x = {.label = "depth of recursion"},
            .y = {.label = "x, edges falling as n^-x"},
            .series = {}};
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    for (const bool lights : {false, true}) {
      PlotSeries line{
          .name = fmt::format("{}, {} lights", scenes[s].all[0].scene, lights ? "with" : "without"),
          .points = {},
          .style = static_cast<int>(s),
          .dashed = lights};
      for (const Curve& curve : scenes[s].all) {
        const std::optional<double> x = last_exponent(curve);
        if (curve.lights == lights && x) {
          line.points.emplace_back(curve.levels, *x);
        }
      }
      if (!line.points.empty()) {
        plot.series.push_back(std::move(line));
      }
    }
  }
  return plot;
}

void describe(const std::vector<SceneCurves>& scenes, ReportPage& page) {
  std::string found;
  for (const SceneCurves& curves : scenes) {
    found +=
        fmt::format("{}: {} and {}. ", curves.all[0].scene, shown(last_exponent(curves.surfaces())),
                    shown(last_exponent(curves.full())));
  }
  page.section("fig12", "Fig. 12: edges by resolution");
  page.beside(
      "The hyperbolic decrease of the percentage of pixels to be oversampled with the linear "
      "growth of the image dimensions. Edges are O(n) pixels of an n x n image, so their share is "
      "O(1/n). A graph of the scene of Fig. 9; its depth and its numbers are not given.",
      "Local exponents, 1 by the law, at the largest size; of the surfaces seen directly, and at "
      "depth 6 with light visibility. " +
          found);
  const Curve& surfaces = scenes[0].surfaces();
  const Curve& full = scenes[0].full();
  page.paragraph(fmt::format(
      "Why the law holds for the first and only slowly for the second. Edges whose curves are L "
      "sides of the image long cross some L n pixels, a share of L/n, as long as pixels are "
      "smaller than the curves and what lies between them. The column 'length' is this share "
      "times n: the length that an image of side n resolves. At depth 1 the curves are outlines "
      "and borders of faces, and in {} it goes from {:.1f} to {:.1f}. At depth 6 every curved "
      "mirror and every glass body shows the scene again, smaller, and in it the images in the "
      "others, so that each level multiplies the images and shrinks them. A finer image finds "
      "edges that the coarser one stepped over or had several of in one pixel: the length goes "
      "from {:.1f} to {:.1f}, and the number of categories, which at depth 1 goes from {} to {}, "
      "from {} to {}. The exponent is 1 less that of the growth of the length. As the depth is "
      "finite so "
      "is the number of images, and once pixels are smaller than the smallest of them the law "
      "holds again: exponents rise with n, and fall, on the whole, with depth.",
      surfaces.scene, length(surfaces.points.front()), length(surfaces.points.back()),
      length(full.points.front()), length(full.points.back()), surfaces.points.front().categories,
      surfaces.points.back().categories, full.points.front().categories,
      full.points.back().categories));
}

}  // namespace

Json study_fig12(const StudySettings& settings, ReportPage& page) {
  std::vector<SceneCurves> scenes{measure(settings, "fig9")};
  if (settings.scene.empty()) {
    scenes.push_back(measure(settings, "fig8"));
    scenes.push_back(measure(settings, "fig10"));
  }
  const std::vector<std::string> columns{"scene",    "levels",      "lights",
                                         "n",        "edge_pixels", "edge_percent",
                                         "exponent", "length",      "categories"};
  Table laws{.columns = columns, .rows = {}};
  Table depths{.columns = columns, .rows = {}};
  Json points = Json::array();
  for (const SceneCurves& curves : scenes) {
    add_rows(curves.surfaces(), laws);
    add_rows(curves.full(), laws);
    add_points(curves.surfaces(), points);
    add_points(curves.full(), points);
    for (const Curve& curve : curves.all) {
      add_rows(curve, depths);
    }
  }
  describe(scenes, page);
  for (const auto& [name, caption, plot] :
       {std::tuple{"fig12-linear", "With linear axes, as in the paper", paper_plot(scenes.front())},
        std::tuple{"fig12", "The share of edge pixels", edge_plot(scenes)},
        std::tuple{"fig12-exponents", "Local exponents", exponent_plot(scenes)},
        std::tuple{"fig12-depths", "The exponent at the largest size", depth_plot(scenes)}}) {
    if (!plot.series.empty()) {
      page.plot(write_plots(settings, name, plot), caption);
    }
  }
  page.table(laws, write_table(settings, "fig12", laws));
  page.link(write_table(settings, "fig12-depths", depths), "every depth, with and without lights");
  return {{"points", points}};
}

}  // namespace raycat::app
