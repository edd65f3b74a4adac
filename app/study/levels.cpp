#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study/study.hpp"
#include "edges/edge_map.hpp"
#include "render/paint.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

// A level of detail of one trace: what Fig. 7 and Fig. 15 count.
struct Level {
  int levels;
  bool lights;
  std::uint64_t edge_pixels;
  std::size_t categories;
};

const char* on_off(bool on) { return on ? "on" : "off"; }

std::vector<std::string> cells(const Level& level, const ImageSize& size) {
  return {std::to_string(level.levels), on_off(level.lights), std::to_string(level.edge_pixels),
          percent(share(level.edge_pixels, size)), std::to_string(level.categories)};
}

const std::vector<std::string> level_columns{"levels", "lights", "edge_pixels", "edge_percent",
                                             "categories"};

Json to_json(const Level& level) {
  return {{"levels", level.levels},
          {"lights", level.lights},
          {"edge_pixels", level.edge_pixels},
          {"categories", level.categories}};
}

Level measure(const CategoryImage& categories, int levels, bool lights) {
  return {.levels = levels,
          .lights = lights,
          .edge_pixels = edge_pixels(categories),
          .categories = categories.table.size()};
}

}  // namespace

Json study_fig7(const StudySettings& settings, ReportPage& page) {
  struct Panel {
    const char* file;
    const char* caption;
    int levels;
    bool lights;
  };
  constexpr int depth = 6;
  constexpr std::array<Panel, 4> panels{
      {{"fig7-depth1", "(b) Depth 1", 1, false},
       {"fig7-depth2", "(c) Depth 2", 2, false},
       {"fig7-depth4", "(d) Depth 4", 4, false},
       {"fig7-depth6-lights", "(e) Depth 6 with light visibility", depth, true}}};

  const StudyScene scene(settings, "fig7", settings.size);
  const Rendering rendering = trace(settings, scene, settings.size, depth);
  CategoryTrees trees(rendering.categories);
  std::vector<ReportPage::Picture> pictures{
      {write_picture(settings, "fig7-original", rendering.colour, scene.label), "(a) Original"}};
  Table table{.columns = level_columns, .rows = {}};
  Json levels = Json::array();
  for (const Panel& panel : panels) {
    const CategoryImage categories = at_detail(scene, trees, panel.levels, panel.lights);
    const Level level = measure(categories, panel.levels, panel.lights);
    pictures.push_back(
        {write_picture(settings, panel.file, line_image(detect_edges(categories)), scene.label),
         panel.caption});
    table.rows.push_back(cells(level, settings.size));
    levels.push_back(to_json(level));
  }
  pictures.push_back(
      {write_picture(settings, "fig7-segments", segment_image(rendering.categories), scene.label),
       "(f) Segmented at depth 6 with light visibility"});

  page.section("fig7", "Fig. 7: levels of detail");
  page.beside(
      "Different levels of detail for edge detection: the original, depths 1, 2 and 4, depth 6 "
      "with light visibility, and segmented at that depth. No numbers are given.",
      fmt::format("{} at {} x {}, traced once with {} levels and lights; the other levels of "
                  "detail are reductions of its categories.",
                  scene.label, settings.size.width, settings.size.height, depth));
  page.pictures(pictures);
  page.table(table, write_table(settings, "fig7", table));
  return {{"scene", scene.label}, {"levels", levels}};
}

Json study_fig15(const StudySettings& settings, ReportPage& page) {
  constexpr int deepest = 8;
  const StudyScene scene(settings, "fig9", settings.size);
  const Rendering rendering = trace(settings, scene, settings.size, deepest);
  CategoryTrees trees(rendering.categories);
  std::vector<ReportPage::Picture> pictures;
  Table table{.columns = level_columns, .rows = {}};
  Json levels = Json::array();
  Plot plot{.title = "Fig. 15: edge pixels by depth of recursion",
            .x = {.label = "depth"},
            .y = {.label = "edge pixels, % of all"},
            .series = {{.name = "with light visibility", .style = 0},
                       {.name = "surfaces alone", .style = 1, .dashed = true}}};
  for (int depth = 1; depth <= deepest; ++depth) {
    for (const bool lights : {true, false}) {
      const CategoryImage categories = at_detail(scene, trees, depth, lights);
      const Level level = measure(categories, depth, lights);
      if (lights) {
        pictures.push_back({write_picture(settings, fmt::format("fig15-depth{}", depth),
                                          line_image(detect_edges(categories)), scene.label),
                            fmt::format("Depth {}", depth)});
      }
      plot.series[lights ? 0 : 1].points.emplace_back(
          depth, 100.0 * share(level.edge_pixels, settings.size));
      table.rows.push_back(cells(level, settings.size));
      levels.push_back(to_json(level));
    }
  }
  page.section("fig15", "Fig. 15: line art by depth");
  page.beside(
      "Line-arts of Figure 9 for several depths of recursion. Observing them, one can better "
      "understand the internal reflection and refraction in transparent objects. The depths are "
      "not given.",
      fmt::format("{} at {} x {}, one trace of {} levels reduced to each depth, with light "
                  "visibility.",
                  scene.label, settings.size.width, settings.size.height, deepest));
  page.pictures(pictures);
  page.table(table, write_table(settings, "fig15", table));
  page.plot(write_plots(settings, "fig15", plot), "Edge pixels by depth");
  return {{"scene", scene.label}, {"levels", levels}};
}

}  // namespace raycat::app
