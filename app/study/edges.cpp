#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study/study.hpp"
#include "edges/edge_map.hpp"
#include "render/paint.hpp"

namespace raycat::app {
namespace {

struct EdgeFigure {
  const char* name;
  const char* heading;
  const char* paper;                               // what it says
  std::optional<std::uint64_t> paper_edge_pixels;  // of 512 x 512
};

// A picture with its edges, as Figs. 8, 9 and 10 have it.
nlohmann::ordered_json study_edges(const EdgeFigure& figure, const StudySettings& settings,
                                   ReportPage& page) {
  constexpr int levels = 8;
  constexpr double paper_pixels = 512.0 * 512.0;
  const std::string name = figure.name;
  const StudyScene scene(settings, name, settings.size);
  const Rendering rendering = trace(settings, scene, settings.size, levels);
  const EdgeMap edges = detect_edges(rendering.categories);
  const std::uint64_t count = edges.count();
  const std::vector<ReportPage::Picture> pictures{
      {write_picture(settings, name + "-picture", rendering.colour, scene.label), "Picture"},
      {write_picture(settings, name + "-overlay", overlay_image(rendering.colour, edges),
                     scene.label),
       "Edges painted black over it"},
      {write_picture(settings, name + "-lines", line_image(edges), scene.label), "Edges alone"}};

  Table table{.columns = {"by", "scene", "width", "height", "levels", "edge_pixels", "edge_percent",
                          "categories"},
              .rows = {{"raycat", scene.label, std::to_string(settings.size.width),
                        std::to_string(settings.size.height), std::to_string(levels),
                        std::to_string(count), percent(share(count, settings.size)),
                        std::to_string(rendering.categories.table.size())}}};
  nlohmann::ordered_json result{{"scene", scene.label},
                                {"edge_pixels", count},
                                {"categories", rendering.categories.table.size()}};
  if (figure.paper_edge_pixels) {
    const auto paper_count = static_cast<double>(*figure.paper_edge_pixels);
    table.rows.push_back({"paper", "its own", "512", "512", "",
                          std::to_string(*figure.paper_edge_pixels),
                          percent(paper_count / paper_pixels), ""});
    result["paper_edge_pixels"] = *figure.paper_edge_pixels;
  }
  page.section(name, figure.heading);
  page.beside(figure.paper,
              fmt::format("{} at {} x {}, depth {} with light visibility: {} edge pixels, {} % of "
                          "all, and {} categories.",
                          scene.label, settings.size.width, settings.size.height, levels, count,
                          percent(share(count, settings.size)), rendering.categories.table.size()));
  page.pictures(pictures);
  page.table(table, write_table(settings, name, table));
  return result;
}

}  // namespace

nlohmann::ordered_json study_fig8(const StudySettings& settings, ReportPage& page) {
  return study_edges(
      {.name = "fig8",
       .heading = "Fig. 8: reflections",
       .paper = "A highly reflective scene. Chosen edges have been enhanced over the "
                "rendered image. The algorithm detects all edges within reflections and "
                "shadows: 23656 of 512 x 512 pixels, 9.02 % (Table 1).",
       .paper_edge_pixels = 23656},
      settings, page);
}

nlohmann::ordered_json study_fig9(const StudySettings& settings, ReportPage& page) {
  return study_edges({.name = "fig9",
                      .heading = "Fig. 9: refraction",
                      .paper = "Refraction example. Chosen edges have been painted black over the "
                               "rendered image. The algorithm reveals structures created by the "
                               "refraction and internal reflection inside the sphere: 43340 pixels "
                               "(Table 1), 16.53 % if the image is 512 x 512 as Fig. 8's is.",
                      .paper_edge_pixels = 43340},
                     settings, page);
}

nlohmann::ordered_json study_fig10(const StudySettings& settings, ReportPage& page) {
  return study_edges({.name = "fig10",
                      .heading = "Fig. 10: composite objects",
                      .paper = "The set operations of union, intersection and subtraction over "
                               "primitive objects sphere and box. Detected edges have been painted "
                               "black over the rendered image. No numbers are given.",
                      .paper_edge_pixels = std::nullopt},
                     settings, page);
}

}  // namespace raycat::app
