#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/comparison.hpp"
#include "app/progress_bar.hpp"
#include "app/study/study.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

struct PaperRow {
  const char* method;
  int edge_pixels;
  double seconds;
};

// A half of the paper's Table 1.
struct PaperTable {
  const char* name;
  const char* heading;
  std::array<PaperRow, 5> rows;
};

constexpr std::array<PaperTable, 2> paper_tables{{{"fig9",
                                                   "Fig. 9",
                                                   {{{"none", 0, 46.3},
                                                     {"primes", 43280, 48.2},
                                                     {"godel", 43330, 97.5},
                                                     {"string", 43330, 50.6},
                                                     {"heap", 43340, 51.7}}}},
                                                  {"fig8",
                                                   "Fig. 8",
                                                   {{{"none", 0, 9.0},
                                                     {"primes", 23630, 9.3},
                                                     {"godel", 23656, 48.7},
                                                     {"string", 23656, 11.4},
                                                     {"heap", 23656, 11.9}}}}}};

MethodTable compare(const StudySettings& settings, const StudyScene& scene) {
  constexpr int repetitions = 5;
  constexpr int levels = 8;
  ProgressBar bar(fmt::format("table1 {}", scene.label), settings.quiet);
  return compare_methods(scene.view.accel(), scene.camera,
                         {.width = settings.size.width,
                          .height = settings.size.height,
                          .levels = levels,
                          .progress = bar.callback()},
                         repetitions);
}

const MethodResult* find(const MethodTable& table, const std::string& method) {
  for (const MethodResult& row : table.methods) {
    if (row.method == method) {
      return &row;
    }
  }
  return nullptr;
}

// The paper's rows in its order, with ours beside them.
Json add_rows(const PaperTable& paper, const std::string& label, const MethodTable& ours,
              Table& table) {
  Json methods = Json::array();
  for (const PaperRow& row : paper.rows) {
    const double paper_ratio = row.seconds / paper.rows[0].seconds;
    const MethodResult none{.method = "none", .ratio_to_none = 1.0};
    const MethodResult* found = find(ours, row.method);
    const MethodResult& mine = found != nullptr ? *found : none;
    const double seconds = found != nullptr ? mine.trace_seconds : ours.none_seconds;
    table.rows.push_back({paper.heading, label, row.method, std::to_string(row.edge_pixels),
                          fmt::format("{:.1f}", row.seconds), fmt::format("{:.3f}", paper_ratio),
                          std::to_string(mine.edge_pixels), std::to_string(mine.missed),
                          std::to_string(mine.false_equalities), std::to_string(mine.overflowed),
                          fmt::format("{:.3f}", seconds),
                          fmt::format("{:.3f}", mine.ratio_to_none)});
    methods.push_back({{"method", row.method},
                       {"edge_pixels", mine.edge_pixels},
                       {"missed", mine.missed},
                       {"false_equalities", mine.false_equalities},
                       {"overflowed", mine.overflowed},
                       {"ratio_to_none", mine.ratio_to_none},
                       {"paper_edge_pixels", row.edge_pixels},
                       {"paper_ratio_to_none", paper_ratio}});
  }
  return {{"figure", paper.name}, {"scene", label}, {"methods", methods}};
}

}  // namespace

Json study_table1(const StudySettings& settings, ReportPage& page) {
  Table table{.columns = {"figure", "scene", "method", "paper_edge_pixels", "paper_seconds",
                          "paper_ratio", "edge_pixels", "missed", "false_equalities",
                          "over_64_bits", "cpu_seconds", "ratio"},
              .rows = {}};
  Json figures = Json::array();
  for (const PaperTable& paper : paper_tables) {
    const StudyScene scene(settings, paper.name, settings.size);
    figures.push_back(add_rows(paper, scene.label, compare(settings, scene), table));
  }
  page.section("table1", "Table 1: the methods compared");
  page.beside(
      "Pixels selected and rendering time of each method, for Figs. 9 and 8. Gödel's time is for "
      "an unoptimized implementation over a modified version of the string method. Besides being "
      "the only method to obtain correct results for all scenes, the performance of the binary "
      "heap method compares favorably with that of the other methods.",
      fmt::format(
          "At {} x {} and depth 8, beside the paper's own figures. Times are CPU seconds on one "
          "thread, medians of renders that took turns; ratios, to a render without categories, "
          "are for the same number of samples, and come from a machine that may be busy. "
          "Primes are compared by their exact products, so what they miss is what the "
          "method cannot tell apart. Missed are edge pixels of heap that the method does "
          "not select, false equalities neighbouring samples that only heap tells apart.",
          settings.size.width, settings.size.height));
  page.table(table, write_table(settings, "table1", table));
  return {{"figures", figures}};
}

}  // namespace raycat::app
