#include "tracer/scene_crossings.hpp"

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "support/scenes.hpp"
#include "tracer/accel.hpp"

namespace raycat {
namespace {

TEST_CASE("every object's crossings are reported in order, set operations applied",
          "[tracer][crossings]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder
      .pair("tube", Operation::difference, Box{.size = {4, 4, 4}}, at(0, 0, 0),
            Box{.size = {2, 2, 9}}, at(0, 0, 0), grey)
      .shape("ball", Sphere{.radius = 0.5}, at(0, 0, 0), grey)
      .mesh("sheet", square(9.0), at(0, 0, 7), grey);
  const Scene scene = builder.take();
  const SceneCrossings crossings(scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> found;

  crossings.cross({.origin = {-6, 0.1, 0}, .direction = {2, 0, 0}}, scratch, found);
  REQUIRE(found.size() == 6);  // into and out of each wall, and the ball
  CHECK(found[0].t == Approx(2.0));
  CHECK(found[1].t == Approx(2.5));
  CHECK(found[1].surface == SurfaceId{6});  // the tool's -x face, seen from inside the tube
  CHECK(found[1].normal == glm::dvec3(1, 0, 0));
  CHECK(scene.surfaces.name(scene.surfaces.object(found[2].surface)) == "ball");
  CHECK(found[5].t == Approx(4.0));
  CHECK_FALSE(found[5].entering);

  // Along the tube only the ball and the sheet are met, the sheet from behind.
  crossings.cross({.origin = {0.1, 0.2, -5}, .direction = {0, 0, 1}}, scratch, found);
  REQUIRE(found.size() == 3);
  CHECK(found[2].t == Approx(12.0));
  CHECK_FALSE(found[2].entering);
  CHECK(found[2].normal == glm::dvec3(0, 0, 1));
}

TEST_CASE("a line through the diagonal of a square crosses it once", "[tracer][crossings]") {
  SceneBuilder builder;
  builder.mesh("sheet", square(1.0), at(0, 0, 0), builder.material({}));
  const Scene scene = builder.take();
  const SceneCrossings crossings(scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> found;
  for (double x = -0.9; x < 1.0; x += 0.1) {
    crossings.cross({.origin = {x, x, 5}, .direction = {0, 0, -1}}, scratch, found);
    CHECK(found.size() == 1);
  }
}

TEST_CASE("images and crossings tell the same faces of a feature texture", "[tracer][crossings]") {
  SceneBuilder builder;
  SurfaceMesh sheet = square(1.0);
  std::vector<std::uint32_t> faces(35);
  std::iota(faces.begin(), faces.end(), 0u);
  sheet.features = std::make_shared<const FeatureMap>(
      FeatureMap{.grid = {.width = 7, .height = 5}, .faces = faces, .place = {}});
  sheet.triangles.face_count = 35;
  builder.mesh("sheet", std::move(sheet), at(2, 3, 4), builder.material({}));
  const Scene scene = builder.take();
  const SceneCrossings crossings(scene);
  const Accel accel(scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> found;
  for (int i = 0; i < 400; ++i) {
    const double x = -0.99 + 0.0049 * i;
    const double y = 0.97 * std::sin(i);
    const Ray ray{.origin = {2 + x, 3 + y, 9}, .direction = {0, 0, -1}};
    crossings.cross(ray, scratch, found);
    REQUIRE(found.size() == 1);
    const auto column = static_cast<std::uint32_t>((x + 1) / 2 * 7);
    const auto row = static_cast<std::uint32_t>((1 - y) / 2 * 5);
    CHECK(found[0].surface == SurfaceId{row * 7 + column});
    CHECK(accel.closest(ray, scratch).value().surface == found[0].surface);
  }
}

}  // namespace
}  // namespace raycat
