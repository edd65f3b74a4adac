#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/comparison.hpp"
#include "app/detail_options.hpp"
#include "app/progress_bar.hpp"
#include "app/report.hpp"
#include "app/view.hpp"
#include "raycat/scene_view.hpp"

namespace raycat::app {
namespace {

struct CompareOptions {
  CommonOptions common;
  ViewOptions view;
  DetailOptions detail;
  int repetitions = 5;
};

nlohmann::ordered_json to_json(const MethodTable& table) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (const MethodResult& row : table.methods) {
    methods.push_back({{"method", row.method},
                       {"edge_pixels", row.edge_pixels},
                       {"missed", row.missed},
                       {"false_equalities", row.false_equalities},
                       {"distinct", row.distinct},
                       {"overflowed", row.overflowed},
                       {"overflowed_80", row.overflowed_80},
                       {"bytes", row.bytes},
                       {"trace_seconds", row.trace_seconds},
                       {"ratio_to_none", row.ratio_to_none}});
    if (row.method == "primes") {
      methods.back()["machine_word"] = {{"edge_pixels", table.machine_word.edge_pixels},
                                        {"missed", table.machine_word.missed},
                                        {"false_equalities", table.machine_word.false_equalities},
                                        {"distinct", table.machine_word.distinct}};
    }
  }
  return {
      {"pixels", table.pixels}, {"none_trace_seconds", table.none_seconds}, {"methods", methods}};
}

void print_table(const MethodTable& table) {
  print(fmt::format("{:<11}{:>12}{:>9}{:>18}{:>10}{:>12}{:>12}{:>9}{:>9}{:>10}", "method",
                    "edge pixels", "missed", "false equalities", "distinct", "> 64 bits",
                    "> 80 bits", "CPU s", "ratio", "memory"));
  print(fmt::format("{:<11}{:>12}{:>9}{:>18}{:>10}{:>12}{:>12}{:>9.3f}{:>9.3f}{:>10}", "none", 0,
                    "-", "-", "-", "-", "-", table.none_seconds, 1.0, "-"));
  for (const MethodResult& row : table.methods) {
    const bool number = row.method == "primes" || row.method == "godel";
    print(fmt::format("{:<11}{:>12}{:>9}{:>18}{:>10}{:>12}{:>12}{:>9.3f}{:>9.3f}{:>7.1f} MB",
                      row.method, row.edge_pixels, row.missed, row.false_equalities, row.distinct,
                      number ? std::to_string(row.overflowed) : "-",
                      number ? std::to_string(row.overflowed_80) : "-", row.trace_seconds,
                      row.ratio_to_none, static_cast<double>(row.bytes) * 1e-6));
  }
  const Comparison& word = table.machine_word;
  print(fmt::format("{:<11}{:>12}{:>9}{:>18}{:>10}", "primes/2^64", word.edge_pixels, word.missed,
                    word.false_equalities, word.distinct));
}

void compare(const CompareOptions& options) {
  const ImageSize size = parse_size(options.view.size);
  SceneFile file = load(options.common);
  file.scene.counted_lights = counted_lights(options.detail);
  const Camera camera = camera_of(file, options.view, size);
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  const SceneView view(std::move(file), camera);
  ProgressBar bar(options.common.scene, options.common.quiet);
  const MethodTable table = compare_methods(view.accel(), camera,
                                            {.width = size.width,
                                             .height = size.height,
                                             .levels = options.view.levels,
                                             .threads = options.common.threads,
                                             .detail = detail_for(options.detail, view.scene()),
                                             .mark_textures = options.detail.mark_textures,
                                             .progress = bar.callback()},
                                            options.repetitions);
  if (options.common.json) {
    print(dump(to_json(table)));
  } else {
    print_table(table);
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compare the categorization methods on a scene: the paper's Table 1");
  add_common(*command, options->common);
  add_view(*command, options->view);
  add_detail(*command, options->detail);
  command
      ->add_option("--repetitions", options->repetitions,
                   "Renders with each method, one thread each and in turns; times are medians")
      ->type_name("N")
      ->check(CLI::Range(5, 1000))
      ->capture_default_str();
  command->callback([options] { compare(*options); });
}

}  // namespace raycat::app
