// What recording categories costs: the same image without and by each method, on one thread each.
// Recording takes in everything up to the finished category image: trees, reduction, encoding,
// interning and numbering.

#include <array>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "io/load_scene.hpp"
#include "render/in_turns.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"

namespace raycat::bench {
namespace {

void recording(benchmark::State& state, const char* file) {
  const SceneFile loaded = load_scene(file);
  const Accel accel(loaded.scene);
  const Camera& camera = loaded.scene.cameras.front();
  const std::vector<std::pair<std::string, Method>> methods{{"heap", Method::heap},
                                                            {"string", Method::string},
                                                            {"primes", Method::primes},
                                                            {"godel", Method::godel}};
  // Counters are CPU seconds a million samples: an image with categories has a row and a column
  // of samples more.
  RayCounts none_rays;
  RayCounts rays;
  std::vector<TimedRender> renders{[&](const RenderSettings& settings) {
    none_rays = {};
    benchmark::DoNotOptimize(render_colour(accel, camera, settings, none_rays));
  }};
  for (const auto& [name, method] : methods) {
    renders.emplace_back([&, how = method](RenderSettings settings) {
      settings.method = how;
      rays = render(accel, camera, settings).rays;
    });
  }
  for ([[maybe_unused]] auto _ : state) {
    const std::vector<double> seconds =
        cpu_seconds_in_turns(renders, {.width = 512, .height = 512});
    state.counters["none"] = 1e6 * seconds[0] / static_cast<double>(none_rays.camera);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      state.counters[methods[m].first] = 1e6 * seconds[m + 1] / static_cast<double>(rays.camera);
    }
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

// A million distinct categories of twelve words, each met twice, into a table and, as a yardstick,
// into the standard library's hash map.
void interning(benchmark::State& state) {
  constexpr std::uint32_t count = 1'000'000;
  const auto words_of = [](std::uint32_t i) {
    std::array<std::uint32_t, 12> words{};
    for (std::uint32_t k = 0; k < words.size(); ++k) {
      words[k] = (k + 1) << 24 | (i >> k & 0xffff);
    }
    words[0] = i;
    return words;
  };
  const auto twice = [&](const auto& intern) {
    const double start = cpu_seconds();
    for (std::uint32_t i = 0; i < 2 * count; ++i) {
      intern(words_of(i % count));
    }
    return cpu_seconds() - start;
  };
  for ([[maybe_unused]] auto _ : state) {
    CategoryTable table;
    state.counters["table"] =
        twice([&](const auto& words) { benchmark::DoNotOptimize(table.intern(words)); });
    std::unordered_map<std::u32string, std::uint32_t> map;
    state.counters["map"] = twice([&](const auto& words) {
      const auto next = static_cast<std::uint32_t>(map.size());
      benchmark::DoNotOptimize(map.try_emplace({words.begin(), words.end()}, next));
    });
    if (table.size() != count || map.size() != count) {
      state.SkipWithError("not a million categories");
    }
  }
}

BENCHMARK(interning)->Name("million")->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raycat::bench

int main(int argc, char** argv) {
  std::vector<raycat::bench::Ratio> ratios;
  for (const char* scene : {"fig8", "fig9"}) {
    ratios.push_back({scene, "heap", "none", 1.03});
    ratios.push_back({scene, "string", "none", 1.05});
    ratios.push_back({scene, "primes", "none", 1.05});
    ratios.push_back({scene, "godel", "none", 2.0});
  }
  ratios.push_back({"million", "table", "map", {}});
  return raycat::bench::run(argc, argv, ratios);
}
