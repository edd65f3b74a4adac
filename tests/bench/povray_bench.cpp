// fig10.gltf against POV-Ray on the same scene as `convert` writes it, one thread each, without
// antialiasing. POV-Ray's time is what it prints of its own tracing; ours is that of render(),
// categories and all.

#include <optional>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "io/load_scene.hpp"
#include "io/povray/file.hpp"
#include "render/render.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/povray_time.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tests/support/temporary_folder.hpp"

namespace raycat::bench {
namespace {

constexpr int image_side = 512;

void fig10(benchmark::State& state) {
  const SceneFile loaded = load_scene(RAYCAT_SCENES "/fig10.gltf");
  const Accel accel(loaded.scene);
  const Camera& camera = loaded.scene.cameras.front();
  const RenderSettings settings{.width = image_side, .height = image_side};
  const TemporaryFolder folder;
  write_pov(folder / "fig10.pov", loaded.scene,
            {.camera = camera, .width = image_side, .height = image_side});
  for ([[maybe_unused]] auto _ : state) {
    const std::optional<double> povray = povray_trace_seconds(folder / "fig10.pov", image_side);
    if (!povray) {
      state.SkipWithError("povray does not trace fig10.pov");
      break;
    }
    state.counters["povray"] = *povray;
    state.counters["heap"] =
        timed([&] { benchmark::DoNotOptimize(render(accel, camera, settings)); });
    RayCounts rays;
    state.counters["none"] =
        timed([&] { benchmark::DoNotOptimize(render_colour(accel, camera, settings, rays)); });
  }
}

BENCHMARK(fig10)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  using namespace raycat::bench;
  if (!povray_present()) {
    fmt::print("povray is not installed: skipped\n");
    return 0;
  }
  return run(argc, argv, {{"fig10", "heap", "povray", 1.0}, {"fig10", "none", "povray", {}}});
}
