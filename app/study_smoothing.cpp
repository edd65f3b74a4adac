// Section 4, antialiasing: Fig. 13, and Table 2 with what it could not say, how good the pictures
// are.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/antialias_options.hpp"
#include "app/progress_bar.hpp"
#include "app/study.hpp"
#include "edges/edge_map.hpp"
#include "render/image_quality.hpp"
#include "render/paint.hpp"
#include "render/scene_sampler.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int levels = 8;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A method with all that it is given; those of one family are joined in plots.
struct Choice {
  std::string family;
  std::string knobs;
  AntialiasOptions options;
};

std::vector<Choice> choices() {
  std::vector<Choice> all;
  for (const int side : {2, 3, 4, 6}) {
    all.push_back({"uniform",
                   fmt::format("--samples {}", side),
                   {.method = Smoothing::uniform, .samples = side}});
  }
  for (const int side : {2, 4, 8}) {
    for (const float t : {0.2f, 0.1f, 0.05f, 0.02f, 0.01f}) {
      all.push_back({fmt::format("threshold {}x{}", side, side),
                     fmt::format("--samples {} --threshold {}", side, t),
                     {.method = Smoothing::threshold, .samples = side, .threshold = t}});
    }
  }
  for (const int side : {4, 8, 16}) {
    for (const float t : {0.3f, 0.1f, 0.05f, 0.02f, 0.01f}) {
      all.push_back({fmt::format("whitted {}", side),
                     fmt::format("--samples {} --threshold {}", side, t),
                     {.method = Smoothing::whitted, .samples = side, .threshold = t}});
    }
  }
  for (const int side : {8, 16}) {
    for (const float t : {0.2f, 0.1f, 0.05f, 0.03f, 0.02f, 0.01f, 0.006f, 0.003f, 0.002f}) {
      all.push_back(
          {fmt::format("whitted {} by area", side),
           fmt::format("--samples {} --threshold {} --by-area", side, t),
           {.method = Smoothing::whitted, .samples = side, .threshold = t, .by_area = true}});
    }
  }
  for (const int side : {2, 4, 8}) {
    all.push_back({"category",
                   fmt::format("--samples {}", side),
                   {.method = Smoothing::category, .samples = side}});
  }
  for (const int side : {2, 4, 8}) {
    all.push_back({"category recursive",
                   fmt::format("--samples {} --recursive", side),
                   {.method = Smoothing::category, .samples = side, .recursive = true}});
  }
  for (const bool colour_only : {false, true}) {
    for (const float e :
         {0.1f, 0.05f, 0.03f, 0.02f, 0.01f, 0.007f, 0.005f, 0.003f, 0.002f, 0.001f, 0.0005f}) {
      all.push_back({colour_only ? "adaptive colour-only" : "adaptive",
                     fmt::format("--quality {}{}", e, colour_only ? " --colour-only" : ""),
                     {.method = Smoothing::adaptive, .quality = e, .colour_only = colour_only}});
    }
  }
  return all;
}

// What a choice made of a scene.
struct Outcome {
  const Choice* choice = nullptr;
  double per_pixel = 0.0;
  double category_only = 0.0;
  double cpu = 0.0;
  double linear = 0.0;   // PSNR
  double encoded = 0.0;  // PSNR
  double similarity = 0.0;
};

struct Sweep {
  std::string scene;
  std::string stem;  // of files about it
  ImageSize size;
  std::vector<Outcome> outcomes;
};

SmoothPicture smoothed(const StudySettings& settings, const StudyScene& scene,
                       const ImageSize& size, const AntialiasOptions& options) {
  SceneSampler sampler(scene.accel, scene.camera, size.width, size.height, levels,
                       settings.threads);
  return smooth(
      sampler,
      {.width = size.width, .height = size.height, .threads = settings.threads, .progress = {}},
      options);
}

// Samples a side of a pixel.
constexpr int reference_side = 32;
constexpr int quick_reference_side = 6;

Pixels reference_of(const StudySettings& settings, const StudyScene& scene, const ImageSize& size) {
  ProgressBar bar(fmt::format("{} {}x{}", scene.label, size.width, size.height), settings.quiet);
  SceneSampler sampler(scene.accel, scene.camera, size.width, size.height, levels,
                       settings.threads);
  return smooth_uniformly(sampler,
                          {.width = size.width,
                           .height = size.height,
                           .threads = settings.threads,
                           .progress = bar.callback()},
                          settings.quick ? quick_reference_side : reference_side)
      .colour;
}

Sweep sweep(const StudySettings& settings, const StudyScene& scene, const std::string& stem,
            const ImageSize& size, const std::vector<Choice>& all, const Pixels& reference) {
  Sweep out{.scene = scene.label, .stem = stem, .size = size, .outcomes = {}};
  const double pixels = static_cast<double>(size.width) * size.height;
  for (const Choice& choice : all) {
    const double start = cpu_seconds();
    const SmoothPicture picture = smoothed(settings, scene, size, choice.options);
    const double seconds = cpu_seconds() - start;
    const SampleCounts& samples = picture.samples;
    out.outcomes.push_back(
        {.choice = &choice,
         .per_pixel = static_cast<double>(samples.colour + samples.category_only) / pixels,
         .category_only = static_cast<double>(samples.category_only) / pixels,
         .cpu = seconds,
         .linear = psnr(picture.colour, reference),
         .encoded = psnr_encoded(picture.colour, reference),
         .similarity = ssim(picture.colour, reference, size.width)});
  }
  return out;
}

// The least of `cost` at which outcomes of a family reach a PSNR, between two of them if that is
// less than any one that exceeds it.
template <typename Cost>
std::optional<double> least(const Sweep& sweep, const std::string& family, double target,
                            const Cost& cost) {
  std::vector<glm::dvec2> points;
  for (const Outcome& outcome : sweep.outcomes) {
    if (outcome.choice->family.starts_with(family) &&
        (family != "adaptive" || outcome.choice->family == family)) {
      points.emplace_back(outcome.linear, cost(outcome));
    }
  }
  std::optional<double> best;
  const auto offer = [&](double value) { best = std::min(best.value_or(value), value); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].x >= target) {
      offer(points[i].y);
    }
    if (i > 0 && points[i - 1].x < target && points[i].x > target) {
      const double part = (target - points[i - 1].x) / (points[i].x - points[i - 1].x);
      offer(std::exp((1.0 - part) * std::log(points[i - 1].y) + part * std::log(points[i].y)));
    }
  }
  return best;
}

constexpr double no_less = 1e-9;

double extra(const Outcome& outcome) { return std::max(outcome.per_pixel - 1.0, no_less); }

// Adaptive over the better of the threshold method and Whitted's.
template <typename Cost>
std::optional<double> ratio(const Sweep& sweep, double target, const Cost& cost) {
  const auto ours = least(sweep, "adaptive", target, cost);
  const auto threshold = least(sweep, "threshold", target, cost);
  const auto whitted = least(sweep, "whitted", target, cost);
  if (!ours || (!threshold && !whitted)) {
    return std::nullopt;
  }
  return *ours / std::min(threshold.value_or(std::numeric_limits<double>::infinity()),
                          whitted.value_or(std::numeric_limits<double>::infinity()));
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.2f}", *value) : "";
}

constexpr double targets[] = {46.0, 50.0, 54.0, 58.0};

template <typename X, typename Y>
Plot plot_of(const Sweep& sweep, const std::string& title, const PlotAxis& x, const PlotAxis& y,
             const X& x_of, const Y& y_of) {
  Plot plot{.title = title, .x = x, .y = y, .series = {}};
  static const std::vector<std::string> drawn{
      "adaptive",   "adaptive colour-only", "whitted 16 by area",
      "whitted 16", "threshold 4x4",        "category",
      "uniform"};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    PlotSeries series{.name = drawn[i],
                      .points = {},
                      .style = static_cast<int>(i),
                      .dashed = drawn[i] == "adaptive colour-only"};
    for (const Outcome& outcome : sweep.outcomes) {
      if (outcome.choice->family == drawn[i]) {
        series.points.emplace_back(x_of(outcome), y_of(outcome));
      }
    }
    if (!series.points.empty()) {
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

void show(const StudySettings& settings, const Sweep& sweep, ReportPage& page) {
  const std::string where =
      fmt::format("{} {}x{}", sweep.scene, sweep.size.width, sweep.size.height);
  const std::string name =
      fmt::format("table2-{}-{}x{}", sweep.stem, sweep.size.width, sweep.size.height);
  const PlotAxis rays{.label = "rays per pixel", .scale = AxisScale::decimal};
  const PlotAxis cpu{.label = "CPU seconds", .scale = AxisScale::decimal};
  const auto per_pixel = [](const Outcome& o) { return o.per_pixel; };
  const auto seconds = [](const Outcome& o) { return std::max(o.cpu, 1e-4); };
  const auto linear = [](const Outcome& o) { return o.linear; };
  const auto encoded = [](const Outcome& o) { return o.encoded; };
  const auto similarity = [](const Outcome& o) { return o.similarity; };
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
       {std::pair{"adaptive", AntialiasOptions{.method = Smoothing::adaptive, .quality = 0.005f}},
        {"whitted",
         AntialiasOptions{
             .method = Smoothing::whitted, .samples = 16, .threshold = 0.03f, .by_area = true}}}) {
    const SmoothPicture picture = smoothed(settings, scene, size, options);
    Image image(size.width, size.height);
    image.pixels = difference(picture.colour, reference, gain);
    pictures.push_back(
        {write_picture(settings, fmt::format("table2-{}-{}", stem, what), image, scene.label),
         fmt::format("{} of {}: {:.2f} rays a pixel, {:.1f} dB; what is wrong, {} times", what,
                     scene.label,
                     static_cast<double>(picture.samples.colour + picture.samples.category_only) /
                         (static_cast<double>(size.width) * size.height),
                     psnr(picture.colour, reference), gain)});
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
      {"Thresholding", {.method = Smoothing::threshold, .samples = 2, .threshold = 0.1f}},
      {"Whitted", {.method = Smoothing::whitted, .samples = 4, .threshold = 0.1f}},
      {"Categories", {.method = Smoothing::category, .samples = 2}},
      {"Adaptive (ours)", {.method = Smoothing::adaptive}}};
  for (const auto& [name, options] : methods) {
    table.rows.push_back({name});
  }
  for (const ImageSize& size : sizes) {
    table.columns.push_back(fmt::format("{}x{}", size.width, size.height));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const SmoothPicture picture = smoothed(settings, scene, size, methods[i].second);
      table.rows[i].push_back(fmt::format(
          "{:.2f}", static_cast<double>(picture.samples.colour + picture.samples.category_only) /
                        (static_cast<double>(size.width) * size.height)));
    }
  }
  return table;
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
      "two categories apart, and against CPU time.");
  page.table(paper_table(), write_table(settings, "table2-paper", paper_table()));
  std::vector<Choice> all = choices();
  if (settings.quick) {
    constexpr std::size_t every = 7;
    std::size_t number = 0;
    std::erase_if(all, [&](const Choice&) { return number++ % every != 0; });
  }
  Table points{.columns = {"scene", "size", "method", "options", "rays_per_pixel", "category_only",
                           "cpu_seconds", "psnr", "psnr_encoded", "ssim"},
               .rows = {}};
  Table reach{.columns = {"scene", "size", "dB", "rays", "CPU time"}, .rows = {}};
  Json result{{"ratios", Json::array()}};
  for (const std::string& name : names) {
    const StudyScene scene(settings, name, sizes.front());
    const std::string stem = name.empty() ? "scene" : name;
    const Table table = our_table(settings, scene, sizes);
    page.paragraph(scene.label);
    page.table(table, write_table(settings, "table2-samples-" + stem, table));
    for (const ImageSize& size : sizes) {
      const Pixels reference = reference_of(settings, scene, size);
      const Sweep outcomes = sweep(settings, scene, stem, size, all, reference);
      const std::string dimensions = fmt::format("{}x{}", size.width, size.height);
      for (const Outcome& o : outcomes.outcomes) {
        points.rows.push_back({scene.label, dimensions, o.choice->family, o.choice->knobs,
                               fmt::format("{:.4f}", o.per_pixel),
                               fmt::format("{:.4f}", o.category_only), fmt::format("{:.4f}", o.cpu),
                               fmt::format("{:.2f}", o.linear), fmt::format("{:.2f}", o.encoded),
                               fmt::format("{:.5f}", o.similarity)});
      }
      for (const double target : targets) {
        const auto rays = ratio(outcomes, target, extra);
        const auto cpu = ratio(outcomes, target, [](const Outcome& o) { return o.cpu; });
        reach.rows.push_back(
            {scene.label, dimensions, fmt::format("{:.0f}", target), shown(rays), shown(cpu)});
        result["ratios"].push_back({{"scene", scene.label},
                                    {"size", dimensions},
                                    {"db", target},
                                    {"extra_rays", rays ? Json(*rays) : Json(nullptr)},
                                    {"cpu", cpu ? Json(*cpu) : Json(nullptr)}});
      }
      show(settings, outcomes, page);
      if (&size == &sizes.back()) {
        show_differences(settings, scene, stem, size, reference, page);
      }
    }
  }
  page.paragraph(
      "What adaptive needs of what the better of the threshold method and Whitted's needs, with "
      "any "
      "of their options, for the same PSNR in linear light: of the rays beyond one a pixel, and of "
      "CPU time. Empty where a method does not get there.");
  page.table(reach, write_table(settings, "table2-ratios", reach));
  page.link(write_table(settings, "table2", points), "every method with every option");
  return result;
}

Json study_fig13(const StudySettings& settings, ReportPage& page) {
  const StudyScene scene(settings, "fig9", settings.size);
  const Rendering rendering = trace(settings, scene, settings.size, levels);
  const EdgeMap edges = detect_edges(rendering.categories);
  const SmoothPicture smooth =
      smoothed(settings, scene, settings.size, {.method = Smoothing::category, .samples = 4});
  Image result(settings.size.width, settings.size.height);
  result.pixels = smooth.colour;
  page.section("fig13", "Fig. 13: antialiasing");
  page.beside(
      "Antialiasing process. (a) Original image for which category information is generated; (b) "
      "pixels chosen for antialiasing by the edge detection method; (c) result of oversampling "
      "chosen pixels.",
      fmt::format(
          "The same of {}, 4 x 4 squares of samples in chosen pixels: {:.2f} samples a pixel.",
          scene.label,
          static_cast<double>(smooth.samples.colour) /
              (static_cast<double>(settings.size.width) * settings.size.height)));
  page.pictures({{write_picture(settings, "fig13-original", rendering.colour, scene.label), "(a)"},
                 {write_picture(settings, "fig13-chosen", edge_image(edges), scene.label), "(b)"},
                 {write_picture(settings, "fig13-result", result, scene.label), "(c)"}});
  return {{"chosen", edges.count()}, {"samples", smooth.samples.colour}};
}

}  // namespace raycat::app
