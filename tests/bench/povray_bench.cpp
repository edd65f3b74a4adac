// fig10.gltf against POV-Ray on the same scene, one thread each, without antialiasing. POV-Ray's
// time is what it prints of its own tracing; ours is that of render(), categories and all.

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "io/scene_file.hpp"
#include "render/render.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"

namespace raycat::bench {
namespace {

constexpr int image_side = 512;

bool povray_present() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

// CPU seconds of the trace, from the lines
//     Trace Time:       0 hours  0 minutes  0 seconds (0.221 seconds)
//                 using 1 thread(s) with 0.219 CPU-seconds total
std::optional<double> povray_trace_seconds(const std::string& scene) {
  const std::string command =
      fmt::format("povray +I'{}' +W{} +H{} +WT1 -A -D -V -F 2>&1", scene, image_side, image_side);
  std::FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) {
    return std::nullopt;
  }
  std::optional<double> seconds;
  bool tracing = false;
  std::array<char, 512> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), output) != nullptr) {
    const std::string text = line.data();
    tracing = text.find("Time:") == std::string::npos
                  ? tracing
                  : text.find("Trace Time:") != std::string::npos;
    double cpu = 0.0;
    if (tracing &&
        std::sscanf(line.data(), " using %*d thread(s) with %lf CPU-seconds", &cpu) == 1) {
      seconds = cpu;
    }
  }
  return pclose(output) == 0 ? seconds : std::nullopt;
}

void fig10(benchmark::State& state) {
  const SceneFile loaded = load_scene(RAYCAT_SCENES "/fig10.gltf");
  const Accel accel(loaded.scene);
  const Camera& camera = loaded.scene.cameras.front();
  const RenderSettings settings{.width = image_side, .height = image_side};
  for ([[maybe_unused]] auto _ : state) {
    const std::optional<double> povray = povray_trace_seconds(RAYCAT_BENCH "/fig10.pov");
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
