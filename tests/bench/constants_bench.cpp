// What the numbers in `AdaptiveConstants` are worth: one is changed at a time, and pictures are
// compared with dense uniform samples. Each value is given the PSNR by which it beats the defaults
// at equal rays. No times are taken, and so this is none of the benchmarks that `run` runs:
//
//     constants_bench [WIDTH HEIGHT]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "antialias/adaptive.hpp"
#include "io/load_scene.hpp"
#include "render/image_quality.hpp"
#include "render/scene_sampler.hpp"

namespace raycat::bench {
namespace {

constexpr int levels = 8;
constexpr int reference_samples = 24;  // a side of a pixel

// The errors at which values are tried, and those between and around them which the defaults are
// tried at too, each greater than the next.
constexpr std::array errors{0.02f, 0.01f, 0.005f, 0.003f};
constexpr std::array default_errors{0.08f,  0.057f,  0.04f,   0.028f,  0.02f,
                                    0.014f, 0.01f,   0.007f,  0.005f,  0.004f,
                                    0.003f, 0.0022f, 0.0016f, 0.0011f, 0.0008f};

constexpr std::array scenes{"fig8",        "fig9",     "fig10", "csg_part",
                            "sphereflake", "mesh_csg", "tiles"};

// A constant, and the values to try in place of its default.
struct Tried {
  const char* name;
  float AdaptiveConstants::*constant;
  std::vector<float> values;
};

// How good a picture is, and at what cost.
struct Outcome {
  double extra = 0.0;  // rays a pixel beyond the first
  double quality = 0.0;
};

class Subject {
 public:
  Subject(const char* scene, int width, int height)
      : file_(load_scene(fmt::format("{}/{}.gltf", RAYCAT_SCENES, scene))),
        accel_(file_.scene),
        width_(width),
        height_(height) {
    SceneSampler sampler = new_sampler();
    reference_ = antialias_uniformly(sampler, settings(), reference_samples).without_alpha();
    for (const float error : default_errors) {
      defaults_.push_back(outcome({.error = error}));
    }
  }

  Outcome outcome(const AdaptiveSettings& adaptive) const {
    SceneSampler sampler = new_sampler();
    const AntialiasedPicture picture = antialias_adaptively(sampler, settings(), adaptive);
    return {.extra = static_cast<double>(picture.samples.colour + picture.samples.category_only) /
                         (static_cast<double>(width_) * height_) -
                     1.0,
            .quality = psnr(picture.without_alpha(), reference_)};
  }

  // By how many decibels it is better than the defaults are with as many rays, which is between two
  // of the errors that they were tried at.
  double gain(const Outcome& outcome) const {
    std::size_t next = 1;
    while (next + 1 < defaults_.size() && defaults_[next].extra < outcome.extra) {
      ++next;
    }
    const Outcome& a = defaults_[next - 1];
    const Outcome& b = defaults_[next];
    const double part = std::log(outcome.extra / a.extra) / std::log(b.extra / a.extra);
    return outcome.quality - std::lerp(a.quality, b.quality, part);
  }

 private:
  SceneSampler new_sampler() const {
    return {accel_, file_.scene.cameras.front(), width_, height_, levels, threads_};
  }
  AntialiasSettings settings() const {
    return {.width = width_, .height = height_, .threads = threads_, .progress = {}};
  }

  SceneFile file_;
  Accel accel_;
  int width_;
  int height_;
  int threads_ = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  Pixels reference_;
  std::vector<Outcome> defaults_;  // by `default_errors`
};

struct Mean {
  double mean = 0.0;
  double uncertain = 0.0;  // its standard error
};

Mean mean_of(std::span<const double> numbers) {
  const auto n = static_cast<double>(numbers.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const double number : numbers) {
    sum += number;
    squares += number * number;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / (n - 1.0))};
}

using Subjects = std::vector<std::unique_ptr<Subject>>;  // by `scenes`

// Prints what a constant's value makes of each scene at each error. Returns by how much that is
// better than the defaults, for each scene, in the mean of all errors.
std::vector<double> gains(const Subjects& subjects, const Tried& tried, float value) {
  std::vector<double> sums(subjects.size());
  for (const float error : errors) {
    AdaptiveSettings settings{.error = error};
    settings.constants.*tried.constant = value;
    fmt::print("{:>5} {:>5}", value, error);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const Outcome outcome = subjects[i]->outcome(settings);
      fmt::print(" {:>6.3f} {:.2f}", 1.0 + outcome.extra, outcome.quality);
      sums[i] += subjects[i]->gain(outcome);
    }
    fmt::print("\n");
  }
  for (double& sum : sums) {
    sum /= static_cast<double>(errors.size());
  }
  return sums;
}

void measure(const Subjects& subjects, const Tried& tried) {
  fmt::print("\nrays a pixel and PSNR (dB) by {}\n{:>5} {:>5}", tried.name, "value", "E");
  for (const char* scene : scenes) {
    fmt::print(" {:>12}", scene);
  }
  fmt::print("\n");
  std::vector<std::vector<double>> by_value;
  for (const float value : tried.values) {
    by_value.push_back(gains(subjects, tried, value));
  }
  fmt::print("\ndB beyond the defaults at equal rays by {}\n{:>5} {:>14}", tried.name, "value",
             "mean");
  for (const char* scene : scenes) {
    fmt::print(" {:>11}", scene);
  }
  fmt::print("\n");
  for (std::size_t i = 0; i < by_value.size(); ++i) {
    const Mean mean = mean_of(by_value[i]);
    fmt::print("{:>5} {:>5.2f} +- {:>5.2f}", tried.values[i], mean.mean, mean.uncertain);
    for (const double gain : by_value[i]) {
      fmt::print(" {:>11.2f}", gain);
    }
    fmt::print("{}\n", tried.values[i] == AdaptiveConstants().*tried.constant ? "  default" : "");
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  using namespace raycat::bench;
  using raycat::AdaptiveConstants;
  const int width = argc == 3 ? std::atoi(argv[1]) : 160;
  const int height = argc == 3 ? std::atoi(argv[2]) : 120;
  if ((argc != 1 && argc != 3) || width < 1 || height < 1) {
    fmt::print(stderr, "constants_bench [WIDTH HEIGHT]\n");
    return 2;
  }
  Subjects subjects;
  for (const char* scene : scenes) {
    subjects.push_back(std::make_unique<Subject>(scene, width, height));
  }
  const std::vector<Tried> all{
      {"unseen_bend", &AdaptiveConstants::unseen_bend, {0.0f, 0.02f, 0.04f, 0.08f, 0.16f, 0.32f}},
      {"one_surface",
       &AdaptiveConstants::one_surface,
       {0.0f, 0.04f, 0.08f, 0.15f, 0.2f, 0.3f, 0.6f}},
      {"bent_border", &AdaptiveConstants::bent_border, {0.5f, 0.56f, 0.62f, 0.7f, 0.8f, 1.0f}},
      {"harmless_bend", &AdaptiveConstants::harmless_bend, {0.3f, 0.4f, 0.45f, 0.5f, 0.55f, 0.6f}}};
  for (const Tried& tried : all) {
    measure(subjects, tried);
  }
}
