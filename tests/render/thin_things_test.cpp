#include "render/thin_things.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "support/scenes.hpp"

namespace raycat {
namespace {

// A unit is 10 pixels at the distance of the origin.
const Camera camera{.eye = {0, 0, 10}, .half_height = 0.5};

std::vector<glm::dvec2> thin_things(const Scene& scene) {
  std::vector<glm::dvec2> points;
  for_thin_things(scene, camera, 100, 100,
                  [&](const glm::dvec2& point) { points.push_back(point); });
  return points;
}

TEST_CASE("a primitive that is smaller than a pixel is looked for in its middle", "[render]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("large", Sphere{.radius = 0.08}, at(1, 1, 0), grey)
      .shape("small", Sphere{.radius = 0.04}, at(0.5, -1.25, 0), grey)
      .shape("behind", Sphere{.radius = 0.04}, at(0, 0, 20), grey)
      .shape("outside", Sphere{.radius = 0.04}, at(30, 0, 0), grey);
  const auto points = thin_things(builder.take());
  REQUIRE(points.size() == 1);
  CHECK(points[0].x == Approx(55.0));
  CHECK(points[0].y == Approx(62.5));
}

TEST_CASE("a wire is looked for along its length, as far as it is seen", "[render]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("wire", Box{.size = {400.0, 0.05, 0.05}}, at(0, 0.2, 0), grey);
  const auto points = thin_things(builder.take());
  REQUIRE(points.size() >= 400);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(std::abs(points[i].x - (i > 0 ? points[i - 1].x : 0.0)) < 0.251);
    CHECK(points[i].y == Approx(48.0));
  }
  CHECK(points.back().x > 99.5);
}

TEST_CASE("a plane and a plate are not thin", "[render]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("plane", HalfSpace{}, at(0, -1, 0), grey)
      .shape("plate", Box{.size = {4, 4, 0.01}}, at(0, 0, 0), grey);
  CHECK(thin_things(builder.take()).empty());
}

}  // namespace
}  // namespace raycat
