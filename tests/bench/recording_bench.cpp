// What recording categories costs: the same image with and without, on one thread. Recording
// takes in everything up to the finished category image: trees, reduction, heap encoding,
// interning and numbering.

#include <cstddef>
#include <semaphore>

#include <benchmark/benchmark.h>

#include "categories/render.hpp"
#include "io/scene_file.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tracer/parallel.hpp"

namespace raycat::bench {
namespace {

// Two renders that take turns, a row each, so that whatever slows the machine slows both alike:
// image by image the ratio is uncertain by several percent where other processes run.
class Turns {
 public:
  void wait(int side) { own(side).acquire(); }
  void pass(int side) { own(1 - side).release(); }
  void finish(int side) { own(1 - side).release(most_rows); }

 private:
  static constexpr std::ptrdiff_t most_rows = 1 << 16;

  std::counting_semaphore<>& own(int side) { return side == 0 ? first_ : second_; }

  std::counting_semaphore<> first_{1};
  std::counting_semaphore<> second_{0};
};

// CPU seconds a million samples of `work`, which renders with the settings it is given and returns
// the rays traced: an image with categories has a row and a column of samples more.
template <typename Work>
double in_turn(Turns& turns, int side, const Work& work) {
  double seconds = 0.0;
  turns.wait(side);
  double start = cpu_seconds();
  const RenderSettings settings{.width = 512, .height = 512, .progress = [&](int, int) {
                                  seconds += cpu_seconds() - start;
                                  turns.pass(side);
                                  turns.wait(side);
                                  start = cpu_seconds();
                                }};
  const RayCounts rays = work(settings);
  seconds += cpu_seconds() - start;
  turns.finish(side);
  return 1e6 * seconds / static_cast<double>(rays.camera);
}

void recording(benchmark::State& state, const char* file) {
  const SceneFile loaded = load_scene(file);
  const Accel accel(loaded.scene);
  const Camera& camera = loaded.scene.cameras.front();
  const auto none = [&](const RenderSettings& settings) {
    RayCounts rays;
    benchmark::DoNotOptimize(render_colour(accel, camera, settings, rays));
    return rays;
  };
  const auto heap = [&](const RenderSettings& settings) {
    return render(accel, camera, settings).rays;
  };
  for ([[maybe_unused]] auto _ : state) {
    Turns turns;
    double none_seconds = 0.0;
    double heap_seconds = 0.0;
    parallel_rows(2, 2, [&](int side, int) {
      if (side == 0) {
        none_seconds = in_turn(turns, side, none);
      } else {
        heap_seconds = in_turn(turns, side, heap);
      }
    });
    state.counters["none"] = none_seconds;
    state.counters["heap"] = heap_seconds;
  }
}

BENCHMARK_CAPTURE(recording, fig8, RAYCAT_SCENES "/fig8.gltf")
    ->Name("fig8")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(recording, fig9, RAYCAT_SCENES "/fig9.gltf")
    ->Name("fig9")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  return raycat::bench::run(argc, argv,
                            {{"fig8", "heap", "none", 1.05}, {"fig9", "heap", "none", 1.05}});
}
