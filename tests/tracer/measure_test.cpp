#include "tracer/measure.hpp"

#include <array>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "csg/coincident_leaves.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

constexpr std::uint64_t rays = 1 << 15;
const double pi = glm::pi<double>();

glm::dmat4 turned(double angle) {
  return glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1.0, 2.0, -0.7)));
}

// Within a part of it, and what it says of its own error is true.
void check(const Estimate& found, double expected, double part = 2e-3) {
  CHECK(std::abs(found.value - expected) <= part * expected);
  CHECK(std::abs(found.value - expected) <= 5.0 * found.error + 1e-9 * expected);
  CHECK(found.error <= part * expected);
}

struct Known {
  const char* name;
  Shape shape;
  double volume;
  double area;
};

TEST_CASE("shapes have the volumes and areas of their formulas, however they stand",
          "[tracer][measure]") {
  const Known known = GENERATE(
      Known{"ball", Sphere{2.0}, 32.0 / 3.0 * glm::pi<double>(), 16.0 * glm::pi<double>()},
      Known{"box", Box{{1.0, 2.0, 3.0}}, 6.0, 22.0},
      Known{"cylinder", Cylinder{2.0, 1.0, 1.0}, 2.0 * glm::pi<double>(), 6.0 * glm::pi<double>()},
      Known{"cone", Cylinder{4.0, 0.0, 3.0}, 12.0 * glm::pi<double>(), 24.0 * glm::pi<double>()},
      Known{"ring", Torus{2.0, 0.5}, glm::pi<double>() * glm::pi<double>(),
            4.0 * glm::pi<double>() * glm::pi<double>()});
  const double angle = GENERATE(0.0, 0.9);
  INFO(known.name << " turned by " << angle);
  SceneBuilder builder;
  const glm::dvec3 centre(5.0, -3.0, 2.0);
  builder.shape("it", known.shape, at(5.0, -3.0, 2.0) * turned(angle), builder.material({}));
  const SceneMeasurement found = measure(builder.take(), rays, 1);
  REQUIRE(found.objects.size() == 1);
  CHECK(found.rays == rays);
  const Measurement& one = found.objects.front();
  check(*one.volume, known.volume);
  check(*one.area, known.area, 5e-3);
  for (int k = 0; k < 3; ++k) {
    // The cone's is a quarter of its height above its base, and the others' in the middle.
    if (std::string(known.name) != "cone") {
      CHECK(std::abs(one.centroid->value[k] - centre[k]) <= 5.0 * one.centroid->error[k] + 1e-9);
      CHECK(one.centroid->error[k] < 0.005);
    }
  }
  CHECK(found.total.volume->value == one.volume->value);
  CHECK(found.total.volume->error == one.volume->error);
  CHECK(found.total.area->value == one.area->value);
}

TEST_CASE("a floor is measured where it is no thinner than the tolerance", "[tracer][measure]") {
  const double angle = GENERATE(0.0, 0.35);
  const double width = GENERATE(0.5, 0.99, 1.01, 2.0);
  CAPTURE(angle, width);
  const auto tray = [&](double gap) {
    SceneBuilder builder;
    builder.pair("tray", Operation::difference, Box{{4.0, 1.0, 4.0}}, turned(angle),
                 Box{{2.0, 2.0, 2.0}}, turned(angle) * at(0.0, 0.5 + gap, 0.0),
                 builder.material({}));
    return builder.take();
  };
  const Scene flush = tray(0.0);
  const double tolerance = coincidence_tolerance(bounded_leaves(flush.solids.front().solid.tree()));
  const SceneMeasurement found = measure(tray(width * tolerance), rays, 1);
  check(*found.objects.front().volume, 12.0);
  // Around, above and below, and in the hole.
  check(*found.objects.front().area, width > 1.0 ? 16.0 + 12.0 + 16.0 + 8.0 + 4.0 : 48.0, 5e-3);
}

TEST_CASE("a cone's centroid is a quarter of its height above its base", "[tracer][measure]") {
  SceneBuilder builder;
  builder.shape("cone", Cylinder{4.0, 0.0, 3.0}, glm::dmat4(1.0), builder.material({}));
  const Measurement cone = measure(builder.take(), rays, 1).objects.front();
  CHECK(std::abs(cone.centroid->value.y + 1.0) <= 4.0 * cone.centroid->error.y);
  CHECK(cone.centroid->error.y < 0.002);
}

TEST_CASE("set operations have the volumes and areas of their formulas", "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  const glm::dmat4 upright = turned(0.4);
  const glm::dmat4 lying = upright * glm::rotate(glm::dmat4(1.0), 0.5 * pi, glm::dvec3(1, 0, 0));
  builder
      .pair("Steinmetz", Operation::intersection, Cylinder{6.0, 1.0, 1.0}, upright,
            Cylinder{6.0, 1.0, 1.0}, lying, grey)
      .pair("pipe", Operation::difference, Cylinder{2.0, 1.5, 1.5}, at(9, 0, 0),
            Cylinder{3.0, 1.0, 1.0}, at(9, 0, 0), grey)
      .pair("two boxes", Operation::set_union, Box{glm::dvec3(2.0)}, at(0, 9, 0),
            Box{glm::dvec3(2.0)}, at(1, 10, 9 - 8), grey);
  const SceneMeasurement found = measure(builder.take(), 3 * rays, 1);
  check(*found.objects[0].volume, 16.0 / 3.0);
  check(*found.objects[0].area, 16.0);
  check(*found.objects[1].volume, 2.0 * pi * (2.25 - 1.0));
  check(*found.objects[1].area, 4.0 * pi * (1.5 + 1.0) + 2.0 * pi * (2.25 - 1.0));
  check(*found.objects[2].volume, 15.0);
  check(*found.objects[2].area, 42.0);
  check(*found.total.volume, 16.0 / 3.0 + 2.5 * pi + 15.0);
}

TEST_CASE("what objects have in common counts once in the total", "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  const Box cube{glm::dvec3(2.0)};
  SECTION("an overlap of 1") {
    builder.shape("a", cube, at(0, 0, 0), grey).shape("b", cube, at(1, 1, 1), grey);
    const SceneMeasurement found = measure(builder.take(), rays, 1);
    check(*found.objects[0].volume, 8.0);
    check(*found.objects[1].volume, 8.0);
    check(*found.total.volume, 15.0);
    check(*found.total.area, 42.0);
    for (int k = 0; k < 3; ++k) {
      CHECK(found.total.centroid->value[k] == Approx(0.5).margin(0.005));
    }
    CHECK(found.total.bounds == Bounds{.min = glm::dvec3(-1.0), .max = glm::dvec3(2.0)});
  }
  SECTION("the same thing twice") {
    builder.shape("a", Sphere{1.0}, at(3, 0, 0), grey).shape("b", Sphere{1.0}, at(3, 0, 0), grey);
    const SceneMeasurement found = measure(builder.take(), rays, 1);
    check(*found.total.volume, 4.0 / 3.0 * pi);
    check(*found.total.area, 4.0 * pi);
  }
  SECTION("a face where they touch is inside, also if they are turned") {
    builder.shape("a", cube, turned(0.7) * at(-1, 0, 0), grey);
    builder.shape("b", cube, turned(0.7) * at(1, 0, 0), grey);
    const SceneMeasurement found = measure(builder.take(), rays, 1);
    check(*found.total.volume, 16.0);
    check(*found.total.area, 40.0);
  }
  SECTION("one within another adds nothing, whichever comes first") {
    builder.shape("small", Sphere{0.5}, at(0, 0, 0), grey).shape("large", cube, at(0, 0, 0), grey);
    const SceneMeasurement found = measure(builder.take(), rays, 1);
    check(*found.total.volume, 8.0);
    check(*found.total.area, 24.0);
  }
}

TEST_CASE("neither size nor place costs precision", "[tracer][measure]") {
  const double size = GENERATE(1e-6, 1.0, 1e9);
  const double place = GENERATE(0.0, 1e3, 1e9);  // in sizes
  INFO("size " << size << ", place " << place);
  SceneBuilder builder;
  const glm::dmat4 where = at(place * size, -place * size, 0.0) * turned(0.9);
  builder.shape("ball", Sphere{size}, where, builder.material({}));
  const Measurement ball = measure(builder.take(), rays, 1).objects.front();
  check(*ball.volume, 4.0 / 3.0 * pi * size * size * size);
  check(*ball.area, 4.0 * pi * size * size);
  CHECK(std::abs(ball.centroid->value.x - place * size) <= 1e-3 * size);
  CHECK(ball.bounds.max.x == Approx((place + 1.0) * size).epsilon(1e-15).margin(1e-6 * size));
  CHECK(ball.bounds.min.z == Approx(-size).margin(1e-6 * size));
}

TEST_CASE("bounds are found on creases and tips that no ray of the sums has met",
          "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  const double angle = 0.55;  // of the box around the y axis
  const glm::dmat4 round = glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0, 1, 0));
  builder.shape("cone", Cylinder{4.0, 0.0, 3.0}, glm::dmat4(1.0), grey)
      .shape("leaning box", Box{glm::dvec3(1.0)}, turned(0.6), grey)
      .pair("die", Operation::intersection, Box{glm::dvec3(2.0)}, round, Sphere{1.3}, round, grey);
  const SceneMeasurement found = measure(builder.take(), rays, 1);
  const auto is = [](const Measurement& one, const glm::dvec3& half) {
    for (int k = 0; k < 3; ++k) {
      CHECK(one.bounds.max[k] == Approx(half[k]).epsilon(1e-5));
      CHECK(one.bounds.min[k] == Approx(-half[k]).epsilon(1e-5));
      CHECK(one.bounds_max_error[k] < 1e-4);
    }
  };
  is(found.objects[0], {3.0, 2.0, 3.0});
  const glm::dmat3 box(turned(0.6));
  is(found.objects[1], 0.5 * (glm::abs(box[0]) + glm::abs(box[1]) + glm::abs(box[2])));
  // On the circle where the ball leaves a face of the box.
  const double reach = std::cos(angle) + std::sin(angle) * std::sqrt(1.3 * 1.3 - 1.0);
  is(found.objects[2], {reach, 1.0, reach});
}

TEST_CASE("errors are as large as they are said to be", "[tracer][measure]") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int trials = 0;
  int far_off = 0;
  double squares = 0.0;
  for (int i = 0; i < 150; ++i) {
    glm::dmat4 map(1.0);
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        map[column][row] = normal(random);
      }
    }
    const double scale = std::abs(glm::determinant(glm::dmat3(map)));
    const bool ball = i % 2 == 0;
    SceneBuilder builder;
    builder.shape("it", ball ? Shape(Sphere{1.0}) : Shape(Box{glm::dvec3(1.0)}), map,
                  builder.material({}));
    const Measurement found = measure(builder.take(), 1 << 12, 1).objects.front();
    std::vector<double> off{(found.volume->value - scale * (ball ? 4.0 / 3.0 * pi : 1.0)) /
                            found.volume->error};
    for (int k = 0; k < 3; ++k) {
      off.push_back(found.centroid->value[k] / found.centroid->error[k]);
    }
    if (!ball) {
      const glm::dvec3 x(map[0]);
      const glm::dvec3 y(map[1]);
      const glm::dvec3 z(map[2]);
      const double area = 2.0 * (glm::length(glm::cross(x, y)) + glm::length(glm::cross(y, z)) +
                                 glm::length(glm::cross(z, x)));
      off.push_back((found.area->value - area) / found.area->error);
    }
    for (const double one : off) {
      ++trials;
      squares += one * one;
      far_off += std::abs(one) > 3.0 ? 1 : 0;
    }
  }
  WARN(
      fmt::format("of {} errors, {} are more than 3 of what they are said to be; {:.2f} on the "
                  "average",
                  trials, far_off, std::sqrt(squares / trials)));
  CHECK(far_off <= trials / 50);
  CHECK(squares / trials > 0.4);
  CHECK(squares / trials < 1.3);
}

TEST_CASE("few rays at each of many objects add up to the right total", "[tracer][measure]") {
  // More than one ray in two misses these, which must not make the others count for more.
  constexpr int count = 1500;
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  for (int i = 0; i < count; ++i) {
    builder.shape("needle", Cylinder{4.0, 0.1, 0.1}, at(9.0 * i, 0, 0) * turned(0.8), grey);
  }
  const Measurement total = measure(builder.take(), 1, 2).total;
  const double volume = count * 0.04 * pi;
  CHECK(std::abs(total.volume->value - volume) < 3.5 * total.volume->error);
  CHECK(total.volume->error < 0.1 * volume);
}

TEST_CASE("an open mesh has an area and bounds, and a word on its hole", "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("box", Box{glm::dvec3(1.0)}, at(0, 0, 0), grey)
      .mesh("sheet", square(2.0), at(0, 0, 5), grey);
  const SceneMeasurement found = measure(builder.take(), rays, 1);
  const Measurement& sheet = found.objects[1];
  CHECK_FALSE(sheet.volume);
  CHECK_FALSE(sheet.centroid);
  CHECK(sheet.area->value == 16.0);
  CHECK(sheet.area->error == 0.0);
  CHECK(sheet.bounds == Bounds{.min{-2, -2, 5}, .max{2, 2, 5}});
  CHECK(sheet.problem.find("edge (") == 0);
  CHECK(sheet.problem.find("is open; 4 edges are") != std::string::npos);
  check(*found.total.volume, 1.0);
  check(*found.total.area, 22.0);
  CHECK(found.total.bounds.max == glm::dvec3(2, 2, 5));
}

TEST_CASE("the primitives of a mesh close a volume together, in a mirror, too",
          "[tracer][measure]") {
  // A tetrahedron whose first face is another primitive than the rest.
  SurfaceMesh rest;
  rest.triangles = {.positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    .triangles{{0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
                    .faces{0, 0, 0},
                    .face_count = 1};
  SurfaceMesh base = rest;
  base.triangles.triangles = {{0, 2, 1}};
  base.triangles.faces = {0};
  const double mirror = GENERATE(1.0, -1.0);
  const bool alike = GENERATE(true, false);
  Scene scene;
  scene.materials.emplace_back();
  scene.surfaces.add_object("tetrahedron");
  for (const SurfaceMesh& mesh : {rest, base}) {
    const SurfaceId first = scene.surfaces.add_primitive("part", 1);
    // Unlike matrices that send the base, in the plane z = 0, to one place.
    const double z = !alike && mesh.triangles.triangles.size() == 1 ? 3.0 : 2.0;
    scene.meshes.push_back(
        {.mesh = std::make_shared<const SurfaceMesh>(mesh),
         .transform =
             Affine(at(1, 2, 3) * glm::scale(glm::dmat4(1.0), glm::dvec3(2.0 * mirror, 2.0, z))),
         .first_face = first});
  }
  const Measurement found = measure(scene, rays, 1).objects.front();
  CHECK(found.problem.empty());
  check(*found.volume, 8.0 / 6.0);
  check(*found.area, 6.0 + 2.0 * std::sqrt(3.0));
}

TEST_CASE("what is unbounded is left out of the total", "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("floor", HalfSpace{}, at(0, 0, 0), grey)
      .shape("ball", Sphere{1.0}, at(0, 0, 0), grey)
      .pair("half a ball", Operation::intersection, Sphere{1.0}, at(9, 0, 0), HalfSpace{},
            at(0, 0, 0), grey);
  const SceneMeasurement found = measure(builder.take(), rays, 1);
  CHECK_FALSE(found.objects[0].volume);
  CHECK_FALSE(found.objects[0].area);
  CHECK(found.objects[0].bounds.empty());
  CHECK(found.objects[0].problem == "a half-space leaves it unbounded");
  check(*found.objects[2].volume, 2.0 / 3.0 * pi);
  check(*found.objects[2].area, 3.0 * pi);
  check(*found.total.volume, 2.0 * pi);
}

TEST_CASE("nothing measures zero", "[tracer][measure]") {
  SceneBuilder builder;
  const bool empty_scene = GENERATE(true, false);
  if (!empty_scene) {  // apart, so that they have nothing in common
    builder.pair("nothing", Operation::intersection, Sphere{1.0}, at(0, 0, 0), Sphere{1.0},
                 at(9, 0, 0), builder.material({}));
  }
  const SceneMeasurement found = measure(builder.take(), rays, 1);
  CHECK(found.objects.size() == (empty_scene ? 0 : 1));
  for (const Measurement& one : {found.total, empty_scene ? found.total : found.objects.front()}) {
    CHECK(one.volume->value == 0.0);
    CHECK(one.volume->error == 0.0);
    CHECK(one.area->value == 0.0);
    CHECK_FALSE(one.centroid);
    CHECK(one.bounds.empty());
    CHECK(one.problem.empty());
  }
}

TEST_CASE("what is measured depends on the rays and not on the threads", "[tracer][measure]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.shape("a", Torus{1.0, 0.4}, turned(0.3), grey)
      .shape("b", Sphere{1.0}, at(1, 0, 0), grey)
      .shape("c", Box{glm::dvec3(0.1)}, at(9, 0, 0), grey);
  const Scene scene = builder.take();
  const SceneMeasurement one = measure(scene, 10001, 1);
  CHECK(one.rays == 10001);
  for (const int threads : {2, 7}) {
    const SceneMeasurement many = measure(scene, 10001, threads);
    CHECK(many.total.volume->value == one.total.volume->value);
    CHECK(many.total.volume->error == one.total.volume->error);
    CHECK(many.total.area->value == one.total.area->value);
    CHECK(many.total.centroid->value == one.total.centroid->value);
    CHECK(many.total.centroid->error == one.total.centroid->error);
    CHECK(many.total.bounds == one.total.bounds);
    CHECK(many.objects[0].volume->value == one.objects[0].volume->value);
  }
  CHECK(measure(scene, 1, 1).rays == 3 * 24);
}

}  // namespace
}  // namespace raycat
