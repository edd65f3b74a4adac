// What recording categories costs: the same image without and by each method, on one thread each.
// Recording takes in everything up to the finished category image: trees, reduction, encoding,
// interning and numbering.

#include <array>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "io/scene_file.hpp"
#include "render/render.hpp"
#include "tests/bench/cpu_clock.hpp"
#include "tests/bench/ratio_report.hpp"
#include "tracer/parallel.hpp"

namespace raycat::bench {
namespace {

// Renders that take turns, a row each, so that whatever slows the machine slows all alike: image
// by image the ratio is uncertain by several percent where other processes run.
class Turns {
 public:
  explicit Turns(std::size_t sides) : finished_(sides) {}

  void wait(std::size_t side) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return turn_ == side; });
  }

  void pass(std::size_t side) {
    const std::lock_guard lock(mutex_);
    for (std::size_t k = 1; k <= finished_.size(); ++k) {
      turn_ = (side + k) % finished_.size();
      if (!finished_[turn_]) {
        break;
      }
    }
    changed_.notify_all();
  }

  void finish(std::size_t side) {
    finished_[side] = true;  // it is this side's turn, so that nobody else looks
    pass(side);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<bool> finished_;
  std::size_t turn_ = 0;
};

// CPU seconds a million samples of `work`, which renders with the settings it is given and returns
// the rays traced: an image with categories has a row and a column of samples more.
template <typename Work>
double in_turn(Turns& turns, std::size_t side, const Work& work) {
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
  const std::vector<std::pair<std::string, std::optional<Method>>> sides{{"none", std::nullopt},
                                                                         {"heap", Method::heap},
                                                                         {"string", Method::string},
                                                                         {"primes", Method::primes},
                                                                         {"godel", Method::godel}};
  const auto rendered = [&](RenderSettings settings, std::optional<Method> method) {
    RayCounts rays;
    if (!method) {
      benchmark::DoNotOptimize(render_colour(accel, camera, settings, rays));
      return rays;
    }
    settings.method = *method;
    return render(accel, camera, settings).rays;
  };
  for ([[maybe_unused]] auto _ : state) {
    Turns turns(sides.size());
    std::vector<double> seconds(sides.size());
    const int count = static_cast<int>(sides.size());
    parallel_rows(count, count, [&](int row, int) {
      const auto side = static_cast<std::size_t>(row);
      seconds[side] = in_turn(turns, side, [&](const RenderSettings& settings) {
        return rendered(settings, sides[side].second);
      });
    });
    for (std::size_t side = 0; side < sides.size(); ++side) {
      state.counters[sides[side].first] = seconds[side];
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
