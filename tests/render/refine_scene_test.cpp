#include <catch2/catch.hpp>

#include "edges/refine.hpp"
#include "render/render.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

// A mirror ball over a lit floor, small enough to be sampled whole at subpixels.
Scene ball_on_floor() {
  SceneBuilder builder;
  const MaterialId mirror = builder.material({.reflection = glm::vec3(0.8f)});
  const MaterialId stone = builder.material({.diffuse = {0.7f, 0.6f, 0.5f}});
  builder.shape("ball", Sphere{.radius = 1.0}, at(0, 1, 0), mirror)
      .shape("floor", HalfSpace{}, at(0, 0, 0), stone)
      .light({.position = {3, 5, 4}});
  return builder.take();
}

const Camera view = look_at({1, 2, 5}, {0, 0.7, 0}, {0, 1, 0});

RenderSettings settings(int side, int threads) {
  return {.width = side, .height = side, .levels = 4, .threads = threads};
}

// The table of `rendering` grows by what is found.
RefinedEdges refined(const Accel& accel, Rendering& rendering, int levels, int threads) {
  const RenderSettings as = settings(rendering.categories.width, threads);
  FinerSamples samples(accel, view, as, rendering.categories);
  RefinedEdges edges = refine_edges(rendering.categories, levels, std::ref(samples));
  rendering.categories.table = samples.table();
  rendering.rays += samples.rays();
  return edges;
}

TEST_CASE("refined edges do not depend on the number of threads", "[render][refine]") {
  const Scene scene = ball_on_floor();
  const Accel accel(scene);
  Rendering one = render(accel, view, settings(40, 1));
  Rendering many = render(accel, view, settings(40, 5));
  const RefinedEdges by_one = refined(accel, one, 3, 1);
  const RefinedEdges by_many = refined(accel, many, 3, 5);
  CHECK(by_one.map.pixels == by_many.map.pixels);
  CHECK(by_one.map.count() > 500);
  CHECK(by_one.sampled == by_many.sampled);
  REQUIRE(one.categories.table.size() == many.categories.table.size());
  for (std::uint32_t id = 0; id < one.categories.table.size(); ++id) {
    CHECK(std::ranges::equal(one.categories.table.words(CategoryId{id}),
                             many.categories.table.words(CategoryId{id})));
  }
}

TEST_CASE("refined edges are those of a finer image, but for what the coarser missed",
          "[render][refine]") {
  // The finer image's samples are half a pixel of its own off the subpixels' corners, so its edges
  // are sought beside those marked.
  const Scene scene = ball_on_floor();
  const Accel accel(scene);
  Rendering rendering = render(accel, view, settings(40, 2));
  const EdgeMap map = refined(accel, rendering, 2, 2).map;
  const EdgeMap finer = detect_edges(render(accel, view, settings(160, 2)).categories);
  std::size_t far = 0;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      bool near = false;
      for (int i = 0; i < 25; ++i) {
        // Subpixel (0, 0) starts at the centre of pixel (0, 0), two fine pixels into the image.
        const int fx = x + 2 + i % 5 - 2;
        const int fy = y + 2 + i / 5 - 2;
        near = near || (fx >= 0 && fy >= 0 && fx < 160 && fy < 160 && finer.at(fx, fy));
      }
      far += map.at(x, y) && !near && x < 156 && y < 156 ? 1u : 0u;
    }
  }
  CHECK(map.count() > 500);
  CHECK(far == 0);
}

}  // namespace
}  // namespace raycat
