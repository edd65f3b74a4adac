// What adaptive antialiasing costs beside Whitted's method with differences weighted by area, the
// better of the methods that were there before: Whitted's threshold is the one that gives the same
// PSNR. On one thread each, in CPU seconds, and in rays beyond one a pixel.

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "antialias/adaptive.hpp"
#include "io/load_scene.hpp"
#include "render/image_quality.hpp"
#include "render/in_turns.hpp"
#include "render/scene_sampler.hpp"
#include "tests/bench/ratio_report.hpp"

namespace raycat::bench {
namespace {

constexpr int side = 256;
constexpr int levels = 8;
constexpr int reference_samples = 12;  // a side of a pixel
constexpr int whitted_depth = 4;

using Progress = std::function<void(int done, int rows)>;

class Smoother {
 public:
  Smoother(const Accel& accel, const Camera& camera) : accel_(accel), camera_(camera) {}

  AntialiasedPicture uniform(int samples) const {
    SceneSampler sampler = new_sampler();
    return antialias_uniformly(sampler, settings({}), samples);
  }
  AntialiasedPicture adaptive(const Progress& progress = {}) const {
    SceneSampler sampler = new_sampler();
    return antialias_adaptively(sampler, settings(progress), {});
  }
  AntialiasedPicture whitted(float threshold, const Progress& progress = {}) const {
    SceneSampler sampler = new_sampler();
    return antialias_recursively(sampler, settings(progress), subdivide_by_colour(threshold, true),
                                 whitted_depth);
  }

 private:
  SceneSampler new_sampler() const { return {accel_, camera_, side, side, levels, 1}; }
  static AntialiasSettings settings(const Progress& progress) {
    return {.width = side, .height = side, .threads = 1, .progress = progress};
  }

  const Accel& accel_;
  const Camera& camera_;
};

// The threshold at which Whitted's method is as good as `target`, a PSNR.
float equal_threshold(const Smoother& smoother, const Pixels& reference, double target) {
  float good = 1e-4f;
  float bad = 1.0f;
  for (int step = 0; step < 8; ++step) {
    const float middle = std::sqrt(good * bad);
    (psnr(smoother.whitted(middle).without_alpha(), reference) >= target ? good : bad) = middle;
  }
  return good;
}

double extra_rays(const AntialiasedPicture& picture) {
  return static_cast<double>(picture.samples.colour + picture.samples.category_only) /
             (static_cast<double>(side) * side) -
         1.0;
}

// A scene, and how the two are made to be equally good.
struct Match {
  SceneFile file;
  Accel accel;
  Smoother smoother;
  double quality = 0.0;    // PSNR of both
  float threshold = 0.0f;  // of Whitted's method

  explicit Match(const char* path)
      : file(load_scene(path)), accel(file.scene), smoother(accel, file.scene.cameras.front()) {
    const Pixels reference = smoother.uniform(reference_samples).without_alpha();
    quality = psnr(smoother.adaptive().without_alpha(), reference);
    threshold = equal_threshold(smoother, reference, quality);
  }
};

// Found once, and not again in each repetition: a reference takes longer than all the rest.
const Match& match(const std::string& path) {
  static std::map<std::string, std::unique_ptr<Match>> known;
  std::unique_ptr<Match>& found = known[path];
  if (!found) {
    found = std::make_unique<Match>(path.c_str());
  }
  return *found;
}

void smoothing(benchmark::State& state, const char* file) {
  const Match& both = match(file);
  for ([[maybe_unused]] auto _ : state) {
    AntialiasedPicture ours(0, 0);
    AntialiasedPicture theirs(0, 0);
    const std::vector<double> seconds = cpu_seconds_in_turns(
        {[&](const RenderSettings& turns) { ours = both.smoother.adaptive(turns.progress); },
         [&](const RenderSettings& turns) {
           theirs = both.smoother.whitted(both.threshold, turns.progress);
         }},
        {.width = side, .height = side});
    state.counters["dB"] = both.quality;
    state.counters["adaptive"] = seconds[0];
    state.counters["whitted"] = seconds[1];
    state.counters["adaptive_rays"] = extra_rays(ours);
    state.counters["whitted_rays"] = extra_rays(theirs);
  }
}

BENCHMARK_CAPTURE(smoothing, fig8, RAYCAT_SCENES "/fig8.gltf")
    ->Name("fig8")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smoothing, fig9, RAYCAT_SCENES "/fig9.gltf")
    ->Name("fig9")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(smoothing, fig10, RAYCAT_SCENES "/fig10.gltf")
    ->Name("fig10")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  std::vector<raycat::bench::Ratio> ratios;
  for (const char* scene : {"fig8", "fig9", "fig10"}) {
    ratios.push_back({scene, "adaptive_rays", "whitted_rays", 0.5});
    ratios.push_back({scene, "adaptive", "whitted", 0.8});
  }
  return raycat::bench::run(argc, argv, ratios);
}
