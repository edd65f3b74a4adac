#include "render/scene_sampler.hpp"

#include <tuple>

#include <catch2/catch.hpp>

#include "antialias/adaptive.hpp"
#include "render/coverage.hpp"
#include "render/render.hpp"
#include "render/tree_difference.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

TEST_CASE("trees differ at a node if all that differs hangs below it", "[render][antialias]") {
  const auto node = [](HeapPosition position, std::uint32_t surface, LightMask lights = 0) {
    return RayNode{.position = position, .lights = lights, .surface = SurfaceId{surface}};
  };
  const RayTree tree{node(6, 4), node(2, 1), node(3, 2, 1), node(1, 0, 3)};
  CHECK_FALSE(tree_difference(tree, tree));
  const RayTree other{node(2, 1), node(3, 5, 2), node(1, 0, 3)};
  const auto apart = tree_difference(tree, other).value();
  CHECK(apart.position == 3);
  CHECK(apart.a == SurfaceId{2});
  CHECK(apart.b == SurfaceId{5});
  CHECK_FALSE(apart.light);
  const auto lit =
      tree_difference(tree, {node(6, 4), node(2, 1), node(3, 2, 1), node(1, 0, 1)}).value();
  CHECK(lit.position == 1);
  CHECK(lit.light == 1);
  CHECK(lit.lit_in_a);
  const auto missing = tree_difference(tree, {node(6, 4), node(3, 2, 1), node(1, 0, 3)}).value();
  CHECK(missing.position == 2);
  CHECK_FALSE(missing.b);
  // Two lights, and two branches, are more than one question.
  CHECK_FALSE(tree_difference(tree, {node(6, 4), node(2, 1), node(3, 2, 1), node(1, 0, 0)}));
  CHECK_FALSE(tree_difference(tree, {node(6, 5), node(2, 9), node(3, 2, 1), node(1, 0, 3)}));
}

// A mirror, glass, a box and a floor under two lights.
Scene mixed_scene() {
  SceneBuilder builder;
  const MaterialId mirror =
      builder.material({.diffuse = glm::vec3(0.2f), .reflection = glm::vec3(0.7f)});
  const MaterialId glass = builder.material({.transmission = glm::vec3(0.8f), .ior = 1.4f});
  const MaterialId stone = builder.material({.diffuse = {0.7f, 0.6f, 0.5f}});
  builder.shape("ball", Sphere{.radius = 1.0}, at(-0.8, 0, 0), mirror)
      .shape("bead", Sphere{.radius = 0.7}, at(0.9, 0.2, 1), glass)
      .shape("box", Box{.size = {1, 1, 1}}, at(0.6, -0.4, -1.2), stone)
      .shape("floor", HalfSpace{}, at(0, -1, 0), stone)
      .light({.kind = Light::Kind::point, .position = {3, 5, 4}, .diffuse = glm::vec3(1.0f)})
      .light({.kind = Light::Kind::point, .position = {-4, 4, 2}, .diffuse = glm::vec3(1.0f)});
  return builder.take();
}

const Camera camera = look_at({0, 1, 5}, {0, 0, 0}, {0, 1, 0});

TEST_CASE("sides told cheaply are those of whole samples", "[render][antialias]") {
  const Scene scene = mixed_scene();
  const Accel accel(scene);
  SceneSampler sampler(accel, camera, 40, 40, 6, 1);
  int asked = 0;
  int wrong = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 39; ++x) {
      const TreeId a = sampler.sample(glm::dvec2(x, y), 0).tree;
      const TreeId b = sampler.sample(glm::dvec2(x + 1, y), 0).tree;
      if (a == b) {
        continue;
      }
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const glm::dvec2 point(x + part, y);
        const TreeId whole = sampler.sample(point, 0).tree;
        const auto side = sampler.side(point, a, b, 0);
        if (whole == a || whole == b) {
          ++asked;
          wrong += side == whole ? 0 : 1;
        }
      }
    }
  }
  CHECK(asked > 500);
  CHECK(wrong == 0);
}

TEST_CASE("a transparent backdrop leaves out what rays see that leave at once",
          "[render][antialias]") {
  const Scene scene = mixed_scene();
  const Accel accel(scene);
  SceneSampler shown(accel, camera, 30, 30, 6, 1);
  SceneSampler transparent(accel, camera, 30, 30, 6, 1, Backdrop::transparent);
  int left_out = 0;
  for (int i = 0; i < 30 * 30; ++i) {
    const glm::dvec2 point(i % 30 + 0.5, i / 30 + 0.5);
    const ColourSample with = shown.sample(point, 0);
    const ColourSample without = transparent.sample(point, 0);
    const bool background = shown.tree(with.tree).empty();
    CHECK(with.colour.a == 1.0f);
    CHECK((without.colour == (background ? glm::vec4(0.0f) : with.colour)));
    CHECK(transparent.tree(without.tree) == shown.tree(with.tree));
    left_out += background ? 1 : 0;
  }
  CHECK(left_out > 50);
  CHECK(left_out < 850);
}

TEST_CASE("samples that a render has taken are not traced again, and antialias alike",
          "[render][antialias]") {
  const Scene scene = mixed_scene();
  const Accel accel(scene);
  const RenderSettings settings{.width = 40, .height = 30, .levels = 6, .threads = 3};
  for (const Backdrop backdrop : {Backdrop::shown, Backdrop::transparent}) {
    SceneSampler fresh(accel, camera, 40, 30, 6, 3, backdrop);
    SceneSampler keeper(accel, camera, 40, 30, 6, 3, backdrop, true);
    render(accel, camera, settings, keeper);
    for (const int side : {1, 3}) {
      const auto picture = [&](SceneSampler& sampler) {
        return antialias_uniformly(sampler, {.width = 40, .height = 30, .threads = 3}, side).colour;
      };
      const std::uint64_t before = keeper.rays().camera;
      CHECK((picture(keeper) == picture(fresh)));
      CHECK(keeper.rays().camera - before ==
            static_cast<std::uint64_t>(40 * 30 * (side * side - 1)));
    }
    const auto adaptive = [&](SceneSampler& sampler) {
      return antialias_adaptively(sampler, {.width = 40, .height = 30, .threads = 3}, {}).colour;
    };
    CHECK((adaptive(keeper) == adaptive(fresh)));
  }
}

TEST_CASE("a scene is antialiased alike whatever the number of threads", "[render][antialias]") {
  const Scene scene = mixed_scene();
  const Accel accel(scene);
  const auto antialiased = [&](int threads) {
    SceneSampler sampler(accel, camera, 60, 45, 6, threads);
    const AntialiasedPicture picture = antialias_adaptively(
        sampler, {.width = 60, .height = 45, .threads = threads, .coverage = true, .progress = {}},
        {.error = 0.003f});
    const CoverageImage coverage = coverage_image(
        picture, [&](TreeId id) -> const RayTree& { return sampler.tree(id); }, scene.surfaces, {},
        4);
    return std::tuple(picture.colour, picture.samples.colour, picture.samples.category_only,
                      coverage.ids, coverage.shares, sampler.rays().shadow);
  };
  const auto one = antialiased(1);
  CHECK((antialiased(4) == one));
  CHECK(std::get<2>(one) > 0);  // rays that only told two categories apart
}

}  // namespace
}  // namespace raycat
