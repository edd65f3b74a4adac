#include "tracer/camera.hpp"

#include <cmath>
#include <numbers>
#include <tuple>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace raycat {
namespace {

TEST_CASE("the middle of the image is straight ahead", "[tracer][camera]") {
  const Camera camera = look_at({1, 2, 3}, {4, 2, 3}, {0, 1, 0});
  const Ray ray = ImagePlane(camera, 200, 100).ray(100, 50);
  CHECK(ray.origin == glm::dvec3(1, 2, 3));
  CHECK(ray.direction == glm::dvec3(1, 0, 0));
  CHECK(camera.right == glm::dvec3(0, 0, 1));
  CHECK(camera.up == glm::dvec3(0, 1, 0));
}

TEST_CASE("the height of the image spans the field of view", "[tracer][camera]") {
  Camera camera = look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0});
  camera.half_height = 0.5;
  const Ray top = ImagePlane(camera, 300, 100).ray(150, 0);
  CHECK(top.direction.y / -top.direction.z == Approx(0.5));
  const Ray left = ImagePlane(camera, 300, 100).ray(0, 50);
  CHECK(left.direction.x / -left.direction.z == Approx(-1.5));
}

TEST_CASE("a point is projected to where its ray starts", "[tracer][camera]") {
  Camera camera = look_at({3, -2, 5}, {0, 1, 0.5}, {0, 0, 1});
  camera.orthographic = GENERATE(false, true);
  const ImagePlane plane(camera, 640, 480);
  const glm::dvec2 seen = plane.project(plane.ray(123.25, 456.75).at(7.5));
  CHECK(seen.x == Approx(123.25));
  CHECK(seen.y == Approx(456.75));
}

TEST_CASE("orthographic rays are parallel", "[tracer][camera]") {
  Camera camera = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  camera.orthographic = true;
  camera.half_height = 2.0;
  const Ray ray = ImagePlane(camera, 100, 100).ray(0, 0);
  CHECK(ray.direction == glm::dvec3(0, 0, -1));
  CHECK(ray.origin.x == Approx(-2.0));
  CHECK(ray.origin.y == Approx(2.0));
}

TEST_CASE("a view without a direction is refused", "[tracer][camera]") {
  CHECK_THROWS_WITH(look_at({1, 1, 1}, {1, 1, 1}, {0, 1, 0}),
                    "eye and target of a view must differ");
  CHECK_THROWS_WITH(look_at({NAN, 1, 1}, {1, 1, 1}, {0, 1, 0}),
                    "eye, target and up of a view must be finite numbers");
}

TEST_CASE("looking straight down or up has +X to the right", "[tracer][camera]") {
  const glm::dvec3 x(1, 0, 0);
  const glm::dvec3 y(0, 1, 0);
  const glm::dvec3 z(0, 0, 1);
  for (const auto& [up, down, upright] :
       {std::tuple(y, -y, -z), std::tuple(y, y, z), std::tuple(z, -z, y), std::tuple(z, z, -y)}) {
    const Camera camera = look_at({2, 3, 4}, glm::dvec3(2, 3, 4) + 5.0 * down, up);
    CHECK(camera.right == x);
    CHECK(camera.up == upright);
  }
  const Camera sideways = look_at({0, 0, 0}, {2, 0, 0}, x);
  CHECK(glm::length(sideways.right) == Approx(1.0));
  CHECK(glm::dot(sideways.right, sideways.forward) == 0.0);
}

TEST_CASE("an orbit goes from the front to the right and to the top", "[tracer][camera]") {
  const double quarter = std::numbers::pi / 2.0;
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(a, b) < 1e-15;
  };
  for (const glm::dvec3& up : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
    const glm::dvec3 right(1, 0, 0);
    const glm::dvec3 front = glm::cross(right, up);
    CHECK(near(orbit(up, 0, 0).towards_eye, front));
    CHECK(near(orbit(up, 0, 0).up, up));
    CHECK(near(orbit(up, quarter, 0).towards_eye, right));
    CHECK(near(orbit(up, 0, quarter).towards_eye, up));
    CHECK(near(orbit(up, 0, quarter).up, -front));
    CHECK(near(orbit(up, quarter, quarter).up, -right));
    CHECK(near(orbit(up, 0, -quarter).up, front));
  }
  // Of an isometric view, all axes are seen alike.
  const Orbit iso = orbit({0, 0, 1}, quarter / 2.0, std::asin(1.0 / std::sqrt(3.0)));
  CHECK(near(glm::abs(iso.towards_eye), glm::dvec3(1.0 / std::sqrt(3.0))));
}

TEST_CASE("framing shows the whole box", "[tracer][camera]") {
  const Bounds box{.min = {-1, 10, 5}, .max = {3, 10.5, 9}};
  const auto [width, height] = GENERATE(std::pair(400, 200), std::pair(200, 400));
  const bool orthographic = GENERATE(false, true);
  const glm::dvec3 up = GENERATE(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
  const ImagePlane plane(
      frame(box, three_quarter(up), up, static_cast<double>(width) / height, orthographic), width,
      height);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec2 seen = plane.project({(corner & 1) != 0 ? box.min.x : box.max.x,
                                           (corner & 2) != 0 ? box.min.y : box.max.y,
                                           (corner & 4) != 0 ? box.min.z : box.max.z});
    CHECK((seen.x > 0 && seen.x < width && seen.y > 0 && seen.y < height));
  }
}

TEST_CASE("a scene is framed however far from the origin it is", "[tracer][camera]") {
  Bounds bounds;
  bounds.include(glm::dvec3(-6e16));
  bounds.include(glm::dvec3(-3e16));
  const glm::dvec3 up(0, 1, 0);
  const Camera camera = frame(bounds, three_quarter(up), up, 1.0, false);
  const glm::dvec2 middle = ImagePlane(camera, 100, 100).project(bounds.center());
  CHECK(middle.x == Approx(50.0));
  CHECK(middle.y == Approx(50.0));
}

}  // namespace
}  // namespace raycat
