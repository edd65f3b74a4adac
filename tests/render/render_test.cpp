#include "render/render.hpp"

#include <catch2/catch.hpp>

#include "support/scenes.hpp"

namespace raycat {
namespace {

// A mirror ball and a glass box on a floor, two lights.
Scene shiny() {
  SceneBuilder builder;
  const MaterialId mirror = builder.material(
      {.diffuse = glm::vec3(0.2f), .specular = glm::vec3(0.5f), .reflection = glm::vec3(0.8f)});
  const MaterialId glass = builder.material(
      {.reflection = glm::vec3(0.1f), .transmission = glm::vec3(0.8f), .ior = 1.5f});
  const MaterialId stone = builder.material({.diffuse = {0.7f, 0.6f, 0.5f}});
  builder.shape("ball", Sphere{.radius = 1.0}, at(-1, 1, 0), mirror)
      .shape("box", Box{.size = {1, 1, 1}}, at(1, 0.5, 0.5), glass)
      .shape("floor", HalfSpace{}, at(0, 0, 0), stone)
      .light({.position = {3, 5, 4}})
      .light({.position = {-4, 6, 2}});
  return builder.take();
}

const Camera view = look_at({1, 2, 5}, {0, 0.7, 0}, {0, 1, 0});

RenderSettings settings(int threads) {
  return {.width = 60, .height = 40, .levels = 6, .threads = threads};
}

TEST_CASE("a rendering does not depend on the number of threads", "[categories][render]") {
  const Scene scene = shiny();
  const Accel accel(scene);
  const Rendering one = render(accel, view, settings(1));
  const Rendering many = render(accel, view, settings(5));
  CHECK(one.colour.pixels == many.colour.pixels);
  CHECK(one.categories.samples == many.categories.samples);
  REQUIRE(one.categories.table.size() == many.categories.table.size());
  for (std::uint32_t id = 0; id < one.categories.table.size(); ++id) {
    CHECK(std::ranges::equal(one.categories.table.words(CategoryId{id}),
                             many.categories.table.words(CategoryId{id})));
  }
}

TEST_CASE("categories are numbered in raster order", "[categories][render]") {
  const Scene scene = shiny();
  const Accel accel(scene);
  const Rendering rendering = render(accel, view, settings(3));
  std::uint32_t next = 0;
  for (const CategoryId id : rendering.categories.samples) {
    REQUIRE(static_cast<std::uint32_t>(id) <= next);
    next += static_cast<std::uint32_t>(id) == next ? 1 : 0;
  }
  CHECK(next == rendering.categories.table.size());
  CHECK(next > 30);
}

TEST_CASE("the picture without categories is the same picture", "[categories][render]") {
  const Scene scene = shiny();
  const Accel accel(scene);
  RayCounts rays;
  const Image alone = render_colour(accel, view, settings(2), rays);
  const Rendering both = render(accel, view, settings(2));
  CHECK(alone.pixels == both.colour.pixels);
  CHECK(rays.camera == 60 * 40);
  CHECK(both.rays.camera == 61 * 41);
}

TEST_CASE("a sample's category is that of its own ray tree", "[categories][render]") {
  const Scene scene = shiny();
  const Accel accel(scene);
  const Rendering rendering = render(accel, view, settings(2));
  const Encoder& encoder = *rendering.categories.encoder;
  const ImagePlane plane(view, 60, 40);
  TraceScratch scratch;
  for (int y = 0; y <= 40; y += 4) {
    for (int x = 0; x <= 60; x += 3) {
      RayTree tree;
      trace(accel, plane.sample_ray(x, y), 6, tree, scratch);
      CategoryWords words;
      encode(encoder, tree, words);
      CHECK(std::ranges::equal(rendering.categories.table.words(rendering.categories.at(x, y)),
                               words));
    }
  }
}

TEST_CASE("progress ends with every row done", "[categories][render]") {
  const Scene scene = shiny();
  const Accel accel(scene);
  RenderSettings with = settings(2);
  int last = 0;
  with.progress = [&](int done, int rows) {
    CHECK(rows == 41);
    last = std::max(last, done);
  };
  render(accel, view, with);
  CHECK(last == 41);
}

TEST_CASE("pixels that meet a texture are counted", "[categories][render]") {
  SceneBuilder builder;
  const MaterialId tile = builder.material({.base_texture = TextureMap{}});
  builder.mesh("tile", square(1.0), at(0, 0, 0), tile);
  Scene scene = builder.take();
  scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>{9, 9, 9, 255});
  const Accel accel(scene);
  Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  camera.orthographic = true;
  camera.half_height = 2.0;  // the tile is half as high and wide as the image
  const Rendering rendering = render(accel, camera, {.width = 20, .height = 20, .threads = 2});
  CHECK(textured_pixels(rendering.categories) == 100);
}

}  // namespace
}  // namespace raycat
