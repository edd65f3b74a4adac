// What measuring costs beside its rays: `measure` on csg_part.gltf against a plain loop that takes
// as many lines through the same solid and adds up their chords.

#include <benchmark/benchmark.h>

#include "io/load_scene.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tracer/measure.hpp"
#include "tracer/scrambled_points.hpp"

namespace raycat::bench {
namespace {

double chords(const Solid& solid, std::uint64_t rays) {
  Solid::Scratch scratch;
  const Bounds& box = solid.bounds();
  const ScrambledPoints points(1);
  double sum = 0.0;
  for (std::uint32_t i = 0; i < rays; ++i) {
    const int axis = static_cast<int>(i % 3);
    const glm::dvec2 point = 2.0 * points(i) - 1.0;
    Ray ray{.origin = box.center(), .direction = glm::dvec3(0.0)};
    ray.origin[(axis + 1) % 3] += point.x * box.half_size()[(axis + 1) % 3];
    ray.origin[(axis + 2) % 3] += point.y * box.half_size()[(axis + 2) % 3];
    ray.direction[axis] = 1.0;
    solid.cross(ray, scratch);
    for (const Boundary& boundary : scratch.boundaries) {
      sum += boundary.entering ? -boundary.t : boundary.t;
    }
  }
  return sum;
}

void part(benchmark::State& state) {
  SceneFile file = load_scene(RAYCAT_SCENES "/csg_part.gltf");
  std::erase_if(file.scene.solids,
                [](const SolidObject& object) { return !object.solid.bounds().finite(); });
  for ([[maybe_unused]] auto _ : state) {
    state.counters["measure"] =
        timed([&] { benchmark::DoNotOptimize(measure(file.scene, default_measure_rays, 1)); });
    state.counters["cross"] = timed([&] {
      benchmark::DoNotOptimize(chords(file.scene.solids.front().solid, default_measure_rays));
    });
  }
}

BENCHMARK(part)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  return raycat::bench::run(argc, argv, {{"part", "measure", "cross", 1.5}});
}
