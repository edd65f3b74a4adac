// Section 4, antialiasing: Fig. 13, and Table 2 with what it could not say, how good the pictures
// are.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/study/antialias_sweep.hpp"
#include "app/study/study.hpp"
#include "edges/edge_map.hpp"
#include "render/paint.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double no_less = 1e-9;

double extra(const Antialiased& outcome) { return std::max(outcome.per_pixel - 1.0, no_less); }

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "";
}

constexpr double targets[] = {46.0, 50.0, 54.0, 58.0};

template <typename X, typename Y>
Plot plot_of(const AntialiasSweep& sweep, const std::string& title, const PlotAxis& x,
             const PlotAxis& y, const X& x_of, const Y& y_of) {
  Plot plot{.title = title, .x = x, .y = y, .series = {}};
  struct Drawn {
    const char* family;
    int style;
    bool dashed = false;
  };
  for (const auto& [family, style, dashed] : {Drawn{"adaptive", 0},
                                              {"adaptive colour-only", 0, true},
                                              {"whitted 16 by area", 1},
                                              {"whitted 16", 1, true},
                                              {"threshold 4x4", 2},
                                              {"category", 3},
                                              {"uniform", 4},
                                              {"POV-Ray AM1", 5},
                                              {"POV-Ray AM2", 6}}) {
    PlotSeries series{.name = family, .points = {}, .style = style, .dashed = dashed};
    for (const Antialiased& outcome : sweep.outcomes) {
      if (outcome.family == family) {
        series.points.emplace_back(x_of(outcome), y_of(outcome));
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

void show(const StudySettings& settings, const AntialiasSweep& sweep, ReportPage& page) {
  const std::string where =
      fmt::format("{} {}x{}", sweep.scene, sweep.size.width, sweep.size.height);
  const std::string name =
      fmt::format("table2-{}-{}x{}", sweep.stem, sweep.size.width, sweep.size.height);
  const PlotAxis rays{.label = "rays per pixel", .scale = AxisScale::decimal};
  const PlotAxis cpu{.label = "CPU seconds", .scale = AxisScale::decimal};
  const auto per_pixel = [](const Antialiased& o) { return o.per_pixel; };
  const auto seconds = [](const Antialiased& o) { return std::max(o.cpu, 1e-4); };
  const auto linear = [](const Antialiased& o) { return o.linear; };
  const auto encoded = [](const Antialiased& o) { return o.encoded; };
  const auto similarity = [](const Antialiased& o) { return o.similarity; };
  for (const auto& [suffix, plot] :
       {std::pair{"", plot_of(sweep, where, rays, {.label = "PSNR, linear light (dB)"}, per_pixel,
                              linear)},
        {"-encoded",
         plot_of(sweep, where, rays, {.label = "PSNR, sRGB-encoded (dB)"}, per_pixel, encoded)},
        {"-ssim", plot_of(sweep, where, rays, {.label = "SSIM"}, per_pixel, similarity)},
        {"-cpu",
         plot_of(sweep, where, cpu, {.label = "PSNR, linear light (dB)"}, seconds, linear)}}) {
    page.plot(write_plots(settings, name + suffix, plot), plot.y.label + ", " + where);
  }
}

// What is left to see of the errors of two methods at about the same cost.
void show_differences(const StudySettings& settings, const StudyScene& scene,
                      const std::string& stem, const ImageSize& size, const Pixels& reference,
                      ReportPage& page) {
  constexpr float gain = 8.0f;
  std::vector<ReportPage::Picture> pictures;
  for (const auto& [what, options] :
       {std::pair{"adaptive",
                  AntialiasOptions{.method = AntialiasMethod::adaptive, .quality = 0.005f}},
        {"whitted", AntialiasOptions{.method = AntialiasMethod::whitted,
                    .samples = 16,
                    .threshold = 0.03f,
                    .by_area = true}}}) {
    const AntialiasedPicture picture = antialiased(settings, scene, size, options);
    const Pixels colours = picture.without_alpha();
    Image image(size.width, size.height);
    image.pixels = difference_image(colours, reference, gain);
    pictures.push_back(
        {write_picture(settings, fmt::format("table2-{}-{}", stem, what), image, scene.label),
         fmt::format("{} of {}: {:.2f} rays a pixel, {:.1f} dB; what is wrong, {} times", what,
                     scene.label,
                     static_cast<double>(picture.samples.colour + picture.samples.category_only) /
                         (static_cast<double>(size.width) * size.height),
                     psnr(colours, reference), gain)});
  }
  page.pictures(pictures);
}

Table paper_table() {
  return {.columns = {"method", "160x120", "320x240", "640x480"},
          .rows = {{"Thresholding", "2.10", "1.56", "1.29"},
                   {"Whitted", "3.33", "2.15", "1.52"},
                   {"Primes", "2.27", "1.75", "1.52"}}};
}

// The paper's three methods with the samples of its uniform comparison, 4 a pixel at most.
Table our_table(const StudySettings& settings, const StudyScene& scene,
                const std::vector<ImageSize>& sizes) {
  Table table{.columns = {"method"}, .rows = {}};
  const std::vector<std::pair<const char*, AntialiasOptions>> methods{
      {"Thresholding", {.method = AntialiasMethod::threshold, .samples = 2, .threshold = 0.1f}},
      {"Whitted", {.method = AntialiasMethod::whitted, .samples = 4, .threshold = 0.1f}},
      {"Categories", {.method = AntialiasMethod::category, .samples = 2}},
      {"Adaptive (ours)", {.method = AntialiasMethod::adaptive}}};
  for (const auto& [name, options] : methods) {
    table.rows.push_back({name});
  }
  for (const ImageSize& size : sizes) {
    table.columns.push_back(fmt::format("{}x{}", size.width, size.height));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const AntialiasedPicture picture = antialiased(settings, scene, size, methods[i].second);
      table.rows[i].push_back(fmt::format(
          "{:.2f}", static_cast<double>(picture.samples.colour + picture.samples.category_only) /
                        (static_cast<double>(size.width) * size.height)));
    }
  }
  return table;
}

// What the sweeps of all scenes have found.
struct Found {
  Table points{.columns = {"scene", "size", "method", "options", "rays_per_pixel", "category_only",
                           "cpu_seconds", "psnr", "psnr_encoded", "ssim"},
               .rows = {}};
  Table reach{.columns = {"scene", "size", "dB", "rays", "CPU time"}, .rows = {}};
  Json ratios = Json::array();
};

void add(Found& found, const AntialiasSweep& sweep, const std::string& scene,
         const std::string& size) {
  for (const Antialiased& o : sweep.outcomes) {
    found.points.rows.push_back({scene, size, o.family, o.knobs, fmt::format("{:.4f}", o.per_pixel),
                                 fmt::format("{:.4f}", o.category_only),
                                 fmt::format("{:.4f}", o.cpu), fmt::format("{:.2f}", o.linear),
                                 fmt::format("{:.2f}", o.encoded),
                                 fmt::format("{:.5f}", o.similarity)});
  }
  for (const double target : targets) {
    const auto rays = cost_ratio(sweep, target, extra);
    const auto cpu = cost_ratio(sweep, target, [](const Antialiased& o) { return o.cpu; });
    found.reach.rows.push_back(
        {scene, size, fmt::format("{:.0f}", target), shown(rays), shown(cpu)});
    found.ratios.push_back({{"scene", scene},
                            {"size", size},
                            {"db", target},
                            {"extra_rays", rays ? Json(*rays) : Json(nullptr)},
                            {"cpu", cpu ? Json(*cpu) : Json(nullptr)}});
  }
}

// One scene at all sizes: its tables and plots, and differences of the last size.
void study_scene(const StudySettings& settings, const std::string& name,
                 const std::vector<ImageSize>& sizes, ReportPage& page, Found& found) {
  const StudyScene scene(settings, name, sizes.front());
  const std::string stem = name.empty() ? "scene" : name;
  const Table table = our_table(settings, scene, sizes);
  page.paragraph(scene.label);
  page.table(table, write_table(settings, "table2-samples-" + stem, table));
  for (const ImageSize& size : sizes) {
    const Pixels reference = antialias_reference(settings, scene, size);
    const AntialiasSweep sweep = sweep_antialiasing(settings, scene, stem, size, reference);
    add(found, sweep, scene.label, fmt::format("{}x{}", size.width, size.height));
    show(settings, sweep, page);
    if (&size == &sizes.back()) {
      show_differences(settings, scene, stem, size, reference, page);
    }
  }
}

}  // namespace

Json study_table2(const StudySettings& settings, ReportPage& page) {
  const std::vector<ImageSize> sizes =
      settings.sized ? std::vector{settings.size}
                     : std::vector<ImageSize>{{160, 120}, {320, 240}, {640, 480}, {512, 512}};
  const std::vector<std::string> names =
      settings.scene.empty()
          ? std::vector<std::string>{"fig8",        "fig9",     "fig10", "csg_part",
                                     "sphereflake", "mesh_csg", "tiles"}
          : std::vector<std::string>{""};
  page.section("table2", "Table 2: antialiasing");
  page.beside(
      "Average number of samples per pixel for different antialiasing methods. Uniform "
      "supersampling on every pixel would generate 4 samples per pixel. Of POV-Ray with the primes "
      "product added, and of a scene that is not given. Whitted's method produced considerably "
      "superior results; primes product and the simple threshold method similar ones.",
      "The same methods on scenes of ours, in the same order of cost. How good pictures are, the "
      "plots say: PSNR against rays a pixel, all of which count as one, also those that only told "
      "two categories apart, and against CPU time. Where POV-Ray is installed its two methods are "
      "there too, against its own dense samples.");
  page.table(paper_table(), write_table(settings, "table2-paper", paper_table()));
  Found found;
  for (const std::string& name : names) {
    study_scene(settings, name, sizes, page, found);
  }
  page.paragraph(
      "What adaptive needs of what the better of the threshold method and Whitted's needs, with "
      "any of their options, for the same PSNR in linear light: of the rays beyond one a pixel, "
      "and of CPU time. Empty where a method does not get there.");
  page.table(found.reach, write_table(settings, "table2-ratios", found.reach));
  page.link(write_table(settings, "table2", found.points), "every method with every option");
  return {{"ratios", found.ratios}};
}

Json study_fig13(const StudySettings& settings, ReportPage& page) {
  const StudyScene scene(settings, "fig9", settings.size);
  const Rendering rendering = trace(settings, scene, settings.size, antialias_levels);
  const EdgeMap edges = detect_edges(rendering.categories);
  const AntialiasedPicture picture = antialiased(
      settings, scene, settings.size, {.method = AntialiasMethod::category, .samples = 4});
  Image result(settings.size.width, settings.size.height);
  result.pixels = picture.without_alpha();
  page.section("fig13", "Fig. 13: antialiasing");
  page.beside(
      "Antialiasing process. (a) Original image for which category information is generated; (b) "
      "pixels chosen for antialiasing by the edge detection method; (c) result of oversampling "
      "chosen pixels.",
      fmt::format(
          "The same of {}, 4 x 4 squares of samples in chosen pixels: {:.2f} samples a pixel.",
          scene.label,
          static_cast<double>(picture.samples.colour) /
              (static_cast<double>(settings.size.width) * settings.size.height)));
  page.pictures({{write_picture(settings, "fig13-original", rendering.colour, scene.label), "(a)"},
                 {write_picture(settings, "fig13-chosen", edge_image(edges), scene.label), "(b)"},
                 {write_picture(settings, "fig13-result", result, scene.label), "(c)"}});
  return {{"chosen", edges.count()}, {"samples", picture.samples.colour}};
}

}  // namespace raycat::app
