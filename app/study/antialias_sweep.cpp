#include "app/study/antialias_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "app/progress_bar.hpp"
#include "app/study/povray.hpp"
#include "render/scene_sampler.hpp"

namespace raycat::app {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A method with all that it is given.
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
                   {.method = AntialiasMethod::uniform, .samples = side}});
  }
  for (const int side : {2, 4, 8}) {
    for (const float t : {0.2f, 0.1f, 0.05f, 0.02f, 0.01f}) {
      all.push_back({fmt::format("threshold {}x{}", side, side),
                     fmt::format("--samples {} --threshold {}", side, t),
                     {.method = AntialiasMethod::threshold, .samples = side, .threshold = t}});
    }
  }
  for (const int side : {4, 8, 16}) {
    for (const float t : {0.3f, 0.1f, 0.05f, 0.02f, 0.01f}) {
      all.push_back({fmt::format("whitted {}", side),
                     fmt::format("--samples {} --threshold {}", side, t),
                     {.method = AntialiasMethod::whitted, .samples = side, .threshold = t}});
    }
  }
  for (const int side : {8, 16}) {
    for (const float t : {0.2f, 0.1f, 0.05f, 0.03f, 0.02f, 0.01f, 0.006f, 0.003f, 0.002f}) {
      all.push_back(
          {fmt::format("whitted {} by area", side),
           fmt::format("--samples {} --threshold {} --by-area", side, t),
           {.method = AntialiasMethod::whitted, .samples = side, .threshold = t, .by_area = true}});
    }
  }
  for (const int side : {2, 4, 8}) {
    all.push_back({"category",
                   fmt::format("--samples {}", side),
                   {.method = AntialiasMethod::category, .samples = side}});
  }
  for (const int side : {2, 4, 8}) {
    all.push_back({"category recursive",
                   fmt::format("--samples {} --recursive", side),
                   {.method = AntialiasMethod::category, .samples = side, .recursive = true}});
  }
  for (const bool colour_only : {false, true}) {
    for (const float e :
         {0.1f, 0.05f, 0.03f, 0.02f, 0.01f, 0.007f, 0.005f, 0.003f, 0.002f, 0.001f, 0.0005f}) {
      all.push_back(
          {colour_only ? "adaptive colour-only" : "adaptive",
           fmt::format("--quality {}{}", e, colour_only ? " --colour-only" : ""),
           {.method = AntialiasMethod::adaptive, .quality = e, .colour_only = colour_only}});
    }
  }
  for (const double budget : {1.1, 1.2, 1.3, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0}) {
    all.push_back({"adaptive budget",
                   fmt::format("--budget {}", budget),
                   {.method = AntialiasMethod::adaptive, .budget = budget}});
  }
  return all;
}

// Samples a side of a pixel.
constexpr int reference_side = 32;
constexpr int quick_reference_side = 6;
constexpr int povray_side = 16;

// How often a choice is tried at most, and the seconds after which it is not tried again.
constexpr int most_times = 3;
constexpr double long_enough = 1.5;

Antialiased outcome(std::string family, std::string knobs, const Pixels& colours,
                    const Pixels& reference, const ImageSize& size) {
  return {.family = std::move(family),
          .knobs = std::move(knobs),
          .linear = psnr(colours, reference),
          .encoded = psnr_encoded(colours, reference),
          .similarity = ssim(colours, reference, size.width)};
}

// POV-Ray's two methods, by threshold and depth.
void add_povray(const StudySettings& settings, const StudyScene& scene, AntialiasSweep& sweep) {
  const PovScene povray(scene.view.scene(), scene.camera, sweep.size, antialias_levels,
                        settings.threads);
  const auto reference = povray.reference(settings.quick ? quick_reference_side : povray_side);
  if (!reference) {
    return;
  }
  const std::vector<double> thresholds =
      settings.quick ? std::vector{0.1} : std::vector{0.3, 0.1, 0.03, 0.01};
  for (const int method : {1, 2}) {
    for (const int depth : {2, 3, 4}) {
      for (const double threshold : thresholds) {
        const std::vector<std::string> options{fmt::format("+AM{}", method),
                                               fmt::format("+A{}", threshold),
                                               fmt::format("+R{}", depth)};
        const PovScene::Picture picture = *povray.render(options);
        Antialiased& added = sweep.outcomes.emplace_back(
            outcome(fmt::format("POV-Ray AM{}", method), fmt::format("{}", fmt::join(options, " ")),
                    picture.colour, *reference, sweep.size));
        added.per_pixel = picture.per_pixel;
        added.cpu = picture.cpu;
      }
    }
  }
}

// The least of `cost` at which outcomes of a family reach a PSNR, between two of them if that is
// less than any one that exceeds it.
std::optional<double> least(const AntialiasSweep& sweep, const std::string& family, double target,
                            const std::function<double(const Antialiased&)>& cost) {
  std::vector<glm::dvec2> points;
  for (const Antialiased& outcome : sweep.outcomes) {
    if (outcome.family.starts_with(family) && (family != "adaptive" || outcome.family == family)) {
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

}  // namespace

AntialiasedPicture antialiased(const StudySettings& settings, const StudyScene& scene,
                               const ImageSize& size, const AntialiasOptions& options) {
  SceneSampler sampler(scene.view.accel(), scene.camera, size.width, size.height, antialias_levels,
                       settings.threads);
  return antialias(
      sampler,
      {.width = size.width, .height = size.height, .threads = settings.threads, .progress = {}},
      options);
}

Pixels antialias_reference(const StudySettings& settings, const StudyScene& scene,
                           const ImageSize& size) {
  ProgressBar bar(fmt::format("{} {}x{}", scene.label, size.width, size.height), settings.quiet);
  SceneSampler sampler(scene.view.accel(), scene.camera, size.width, size.height, antialias_levels,
                       settings.threads);
  return antialias_uniformly(sampler,
                             {.width = size.width,
                              .height = size.height,
                              .threads = settings.threads,
                              .progress = bar.callback()},
                             settings.quick ? quick_reference_side : reference_side)
      .without_alpha();
}

AntialiasSweep sweep_antialiasing(const StudySettings& settings, const StudyScene& scene,
                                  const std::string& stem, const ImageSize& size,
                                  const Pixels& reference) {
  AntialiasSweep out{.scene = scene.label, .stem = stem, .size = size, .outcomes = {}};
  std::vector<Choice> all = choices();
  if (settings.quick) {
    constexpr std::size_t every = 7;
    std::size_t number = 0;
    std::erase_if(all, [&](const Choice&) { return number++ % every != 0; });
  }
  const double pixels = static_cast<double>(size.width) * size.height;
  for (const Choice& choice : all) {
    // The least of several times, if it is short: what else the machine does only adds to it.
    double seconds = std::numeric_limits<double>::infinity();
    double spent = 0.0;
    std::optional<AntialiasedPicture> last;
    for (int time = 0; time < (settings.quick ? 1 : most_times) && spent < long_enough; ++time) {
      const double start = cpu_seconds();
      last = antialiased(settings, scene, size, choice.options);
      const double taken = cpu_seconds() - start;
      seconds = std::min(seconds, taken);
      spent += taken;
    }
    const AntialiasedPicture& picture = *last;
    const SampleCounts& samples = picture.samples;
    Antialiased& added = out.outcomes.emplace_back(
        outcome(choice.family, choice.knobs, picture.without_alpha(), reference, size));
    added.per_pixel = static_cast<double>(samples.colour + samples.category_only) / pixels;
    added.category_only = static_cast<double>(samples.category_only) / pixels;
    added.cpu = seconds;
  }
  add_povray(settings, scene, out);
  return out;
}

std::optional<double> cost_ratio(const AntialiasSweep& sweep, double target,
                                 const std::function<double(const Antialiased&)>& cost) {
  const auto ours = least(sweep, "adaptive", target, cost);
  const auto threshold = least(sweep, "threshold", target, cost);
  const auto whitted = least(sweep, "whitted", target, cost);
  if (!ours || (!threshold && !whitted)) {
    return std::nullopt;
  }
  return *ours / std::min(threshold.value_or(std::numeric_limits<double>::infinity()),
                          whitted.value_or(std::numeric_limits<double>::infinity()));
}

}  // namespace raycat::app
