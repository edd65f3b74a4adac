#include "render/in_turns.hpp"

#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "support/scenes.hpp"

namespace raycat {
namespace {

TEST_CASE("renders take turns row by row, each the first of a round in turn", "[render][turns]") {
  std::string order;
  const auto rows = [&](char letter, int count) -> TimedRender {
    return [&order, letter, count](const RenderSettings& settings) {
      CHECK(settings.threads == 1);
      for (int row = 1; row <= count; ++row) {
        order += letter;
        settings.progress(row, count);
      }
    };
  };
  int told = 0;
  const std::vector<double> seconds =
      cpu_seconds_in_turns({rows('a', 3), rows('b', 1), rows('c', 2)},
                           {.threads = 7, .progress = [&](int done, int) { told = done; }});
  // a b c, b c a, c a b: b is done in the second round, c in the third.
  CHECK(order == "abccaa");
  CHECK(told == 3);
  REQUIRE(seconds.size() == 3);
  CHECK(seconds[0] > 0.0);
}

TEST_CASE("a render that takes turns makes what it makes alone", "[render][turns]") {
  SceneBuilder builder;
  const MaterialId stone = builder.material({.diffuse = {0.7f, 0.6f, 0.5f}});
  builder.shape("ball", Sphere{.radius = 1.0}, at(0, 0, 0), stone).light({.position = {3, 5, 4}});
  const Scene scene = builder.take();
  const Accel accel(scene);
  const Camera view = look_at({1, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const RenderSettings settings{.width = 30, .height = 20};
  std::vector<CategoryId> samples;
  cpu_seconds_in_turns(
      {[&](const RenderSettings& own) { samples = render(accel, view, own).categories.samples; },
       [&](const RenderSettings& own) {
         RayCounts rays;
         render_colour(accel, view, own, rays);
       }},
      settings);
  CHECK(samples == render(accel, view, settings).categories.samples);
}

TEST_CASE("one render that fails ends them all with its error", "[render][turns]") {
  const TimedRender fails = [](const RenderSettings&) { throw std::runtime_error("no"); };
  const TimedRender works = [](const RenderSettings& settings) { settings.progress(1, 1); };
  CHECK_THROWS_WITH(cpu_seconds_in_turns({works, fails, works}, {}), "no");
}

}  // namespace
}  // namespace raycat
