#include "tracer/accel.hpp"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "geometry/sample_meshes.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

// Balls, boxes, a ground and squares, some of them single-sided or mirrored, all over the place.
Scene clutter(unsigned seed) {
  std::mt19937 random(seed);
  SceneBuilder builder;
  const MaterialId grey = builder.material({.diffuse = glm::vec3(0.5f)});
  const MaterialId paper = builder.material({.single_sided = true});
  const auto anywhere = [&] {
    return glm::rotate(at(uniform(random, -3, 3), uniform(random, -1, 3), uniform(random, -3, 3)),
                       uniform(random, 0, 6), glm::dvec3(1, 2, 3));
  };
  for (int i = 0; i < 12; ++i) {
    builder.shape("ball", Sphere{.radius = uniform(random, 0.1, 1)}, anywhere(), grey);
    builder.shape("box", Box{.size = glm::dvec3(uniform(random, 0.2, 1))}, anywhere(), grey);
    builder.mesh("square", square(uniform(random, 0.2, 1)), anywhere(), grey);
    builder.mesh("sheet", square(uniform(random, 0.2, 1)), anywhere(), paper);
    builder.mesh("mirrored sheet", square(uniform(random, 0.2, 1)),
                 glm::scale(anywhere(), glm::dvec3(1, i % 2 == 0 ? 1 : -1, -1)), paper);
  }
  builder.shape("ground", HalfSpace{}, at(0, -1, 0), grey);
  return builder.take();
}

// The first surface past t = 0 by asking everything.
Hit brute_force(const Scene& scene, const Ray& ray) {
  Hit best;
  Solid::Scratch scratch;
  for (const SolidObject& object : scene.solids) {
    object.solid.cross(ray, scratch);
    for (const Boundary& boundary : scratch.boundaries) {
      if (boundary.t > 0.0 && boundary.t < best.t) {
        best.t = boundary.t;
        best.surface = object.solid.surface(boundary);
      }
    }
  }
  for (const MeshInstance& instance : scene.meshes) {
    const Ray local = instance.transform.to_local(ray);
    const double t = -local.origin.z / local.direction.z;
    const double half = instance.mesh->triangles.positions[2].x;
    const glm::dvec3 p = local.at(t);
    const bool seen = !scene.materials[static_cast<std::size_t>(instance.material)].single_sided ||
                      local.origin.z > 0.0;
    if (seen && t > 0.0 && t < best.t && std::abs(p.x) < half && std::abs(p.y) < half) {
      best.t = t;
      best.surface = instance.first_face;
    }
  }
  return best;
}

TEST_CASE("the closest hit is the closest of all", "[tracer][accel]") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  const Scene scene = clutter(seed);
  const Accel accel(scene);
  std::mt19937 random(seed);
  Solid::Scratch scratch;
  int hits = 0;
  int wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    // From near, from far off, and with directions of any length.
    const double far = i % 3 == 0 ? 1e4 : 6.0;
    const glm::dvec3 from(uniform(random, -far, far), uniform(random, 0, far),
                          uniform(random, -far, far));
    const glm::dvec3 to(uniform(random, -3, 3), uniform(random, -1, 3), uniform(random, -3, 3));
    const Ray ray{.origin = from, .direction = (to - from) * std::pow(10.0, i % 7 - 3)};
    const Hit expected = brute_force(scene, ray);
    const std::optional<Hit> hit = accel.closest(ray, scratch);
    hits += hit ? 1 : 0;
    wrong += hit.has_value() == std::isfinite(expected.t) &&
                     (!hit || (hit->surface == expected.surface &&
                               std::abs(hit->t - expected.t) <= 1e-12 * expected.t + 1e-15))
                 ? 0
                 : 1;
  }
  CHECK(hits > 2000);
  CHECK(wrong == 0);
}

TEST_CASE("a hit's normal points out of the object, whichever side is met", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  builder.mesh("square", square(1.0), glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, -1)), grey);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  // Mirrored along z, the square's front is at -z.
  const auto front = accel.closest({.origin = {0.1, 0.2, -5}, .direction = {0, 0, 1}}, scratch);
  REQUIRE(front);
  CHECK(front->entering);
  CHECK(front->normal == glm::dvec3(0, 0, -1));
  const auto back = accel.closest({.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}}, scratch);
  REQUIRE(back);
  CHECK_FALSE(back->entering);
  CHECK(back->normal == glm::dvec3(0, 0, -1));
}

TEST_CASE("a ray that leaves a surface does not meet it again", "[tracer][accel]") {
  const double size = GENERATE(1e-6, 1.0, 1e6);
  const double offset = GENERATE(0.0, 1e3);
  SceneBuilder builder;
  const MaterialId grey = builder.material({});
  const glm::dmat4 place = glm::scale(at(offset * size, 0, 0), glm::dvec3(size));
  builder.shape("ball", Sphere{.radius = 1.0}, place, grey);
  builder.mesh("square", square(3.0), place * at(0, 0, -2), grey);
  const Scene scene = builder.take();
  const Accel accel(scene);
  std::mt19937 random(5);
  Solid::Scratch scratch;
  int again = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 local(uniform(random, -2, 2), uniform(random, -2, 2), -1.9);
    const glm::dvec3 eye(uniform(random, -1, 1), uniform(random, -1, 1), 4);
    const Ray ray{.origin = glm::dvec3(place * glm::dvec4(eye, 1)), .direction = local - eye};
    const auto hit = accel.closest(ray, scratch);
    REQUIRE(hit);
    const glm::dvec3 out = glm::reflect(ray.direction, hit->normal);
    const auto next =
        accel.closest({.origin = accel.leave(ray, *hit, hit->normal), .direction = out}, scratch);
    again += next && next->surface == hit->surface ? 1 : 0;
  }
  CHECK(again == 0);
}

TEST_CASE("light is weakened by what it passes, and stopped by what is opaque", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId glass = builder.material({.transmission = glm::vec3(0.5f, 1.0f, 0.25f)});
  const MaterialId stone = builder.material({});
  builder.shape("ball", Sphere{.radius = 1.0}, at(0, 0, 0), glass);
  builder.mesh("pane", square(1.0), at(0, 0, 2), glass);
  builder.shape("wall", Box{.size = {9, 9, 1}}, at(0, 0, 9), stone);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  const Ray ray{.origin = {0.1, 0.1, -5}, .direction = {0, 0, 2}};
  CHECK(accel.transmittance(ray, 1.0, scratch) == glm::vec3(1.0f));
  CHECK(accel.transmittance(ray, 3.2, scratch) == glm::vec3(0.25f, 1.0f, 0.0625f));
  CHECK(accel.transmittance(ray, 4.0, scratch) == glm::vec3(0.125f, 1.0f, 0.015625f));
  CHECK(accel.transmittance(ray, 9.0, scratch) == glm::vec3(0.0f));
}

TEST_CASE(
    "any number of panes weaken light, each once though both triangles of its diagonal are met",
    "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId glass = builder.material({.transmission = glm::vec3(0.9f)});
  const int panes = GENERATE(1, 15, 16, 17, 40);
  for (int i = 0; i < panes; ++i) {
    builder.mesh("pane", square(1.0), at(0, 0, i), glass);
  }
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  for (const double across : {-0.5, -0.25, 0.0, 0.125, 0.5}) {
    for (const double other : {across, -across, 0.3}) {
      const Ray ray{.origin = {across, other, -5}, .direction = {0, 0, 1}};
      CHECK(accel.transmittance(ray, 100.0, scratch).r ==
            Approx(std::pow(0.9, panes)).epsilon(1e-5));
    }
  }
}

// A box from -1 to 1 of triangles.
SurfaceMesh box_of_triangles() {
  SurfaceMesh mesh;
  mesh.triangles = test::box(glm::dvec3(-1.0), glm::dvec3(1.0));
  return mesh;
}

TEST_CASE("light is weakened by the way it goes through what absorbs", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId murky =
      builder.material({.transmission = glm::vec3(1.0f), .absorption = {0.5f, 0.0f, 1.0f}});
  const bool of_triangles = GENERATE(false, true);
  if (of_triangles) {
    builder.mesh("box", box_of_triangles(), at(0, 0, 0), murky);
  } else {
    builder.shape("box", Box{.size = glm::dvec3(2.0)}, at(0, 0, 0), murky);
  }
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  const auto check = [&](double from, double length, double inside) {
    const glm::vec3 is = accel.transmittance({.origin = {0.3, 0.2, from}, .direction = {0, 0, 2}},
                                             length / 2.0, scratch);
    CHECK(is.r == Approx(std::exp(-0.5 * inside)).epsilon(1e-5));
    CHECK(is.g == 1.0f);
    CHECK(is.b == Approx(std::exp(-inside)).epsilon(1e-5));
  };
  check(-5.0, 3.0, 0.0);
  check(-5.0, 10.0, 2.0);
  check(-5.0, 5.5, 1.5);    // ends inside
  check(0.25, 10.0, 0.75);  // starts inside
}

TEST_CASE("light from inside what absorbs to inside what absorbs is weakened by both",
          "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId murky =
      builder.material({.transmission = glm::vec3(1.0f), .absorption = glm::vec3(0.5f)});
  const Shape box = Box{.size = glm::dvec3(2.0)};
  builder.shape("one", box, at(0, 0, 0), murky)
      .shape("another", box, at(0, 0, 6), murky)
      .pair("two of one", Operation::set_union, box, at(9, 0, 0), box, at(9, 0, 6), murky);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  for (const double x : {0.3, 9.3}) {
    const Ray ray{.origin = {x, 0.2, 0.25}, .direction = {0, 0, 2}};  // to z = 6.25
    CHECK(accel.transmittance(ray, 3.0, scratch).r ==
          Approx(std::exp(-0.5 * (0.75 + 1.25))).epsilon(1e-5));
  }
}

TEST_CASE("where a mask cuts a texture away there is no surface", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId leaf = builder.material({.base_texture = TextureMap{}, .alpha_cutoff = 0.5f});
  builder.mesh("leaf", square(1.0), at(0, 0, 0), leaf);
  Scene scene = builder.take();
  // The left half is there, the right half is not.
  scene.textures.emplace_back(2, 1, std::vector<std::uint8_t>{9, 9, 9, 255, 9, 9, 9, 0},
                              Wrap::clamp, Wrap::clamp, true);
  const Accel accel(scene);
  Solid::Scratch scratch;
  const Ray left{.origin = {-0.5, 0, 3}, .direction = {0, 0, -1}};
  const Ray right{.origin = {0.5, 0, 3}, .direction = {0, 0, -1}};
  CHECK(accel.closest(left, scratch));
  CHECK_FALSE(accel.closest(right, scratch));
  CHECK(accel.transmittance(left, 9, scratch) == glm::vec3(0.0f));
  CHECK(accel.transmittance(right, 9, scratch) == glm::vec3(1.0f));
}

TEST_CASE("a closed mesh looks the same from outside, single-sided or not", "[tracer][accel]") {
  const unsigned seed = GENERATE(1u, 2u, 3u, 4u);
  const auto solid = [&](bool single_sided) {
    SceneBuilder builder;
    const MaterialId stone = builder.material({.single_sided = single_sided});
    SurfaceMesh mesh;
    mesh.triangles = test::torus(40, 20, 0.2, seed);
    const glm::dmat4 turned = glm::rotate(at(0.1, 0.2, 0.3), 1.0 * seed, glm::dvec3(1, 2, 3));
    builder.mesh("torus", mesh, glm::scale(turned, glm::dvec3(1, seed % 2 == 0 ? -1 : 1, 2)),
                 stone);
    return builder.take();
  };
  const Scene one = solid(true);
  const Scene both = solid(false);
  const Accel hides(one);
  const Accel shows(both);
  std::mt19937 random(seed);
  Solid::Scratch scratch;
  int hits = 0;
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 from =
        5.0 * glm::normalize(glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1),
                                        uniform(random, -1, 1)));
    const glm::dvec3 to(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2));
    const Ray ray{.origin = from, .direction = to - from};
    const auto hidden = hides.closest(ray, scratch);
    const auto shown = shows.closest(ray, scratch);
    hits += shown ? 1 : 0;
    wrong += hidden.has_value() == shown.has_value() &&
                     (!hidden || (hidden->t == shown->t && hidden->triangle == shown->triangle))
                 ? 0
                 : 1;
  }
  CHECK(hits > 4000);
  CHECK(wrong == 0);
}

TEST_CASE("a back face that is not seen stops light all the same", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId paper = builder.material({.alpha_cutoff = 0.5f, .single_sided = true});
  builder.mesh("sheet", square(1.0), at(0, 0, 0), paper);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  const Ray from_front{.origin = {0.1, 0.2, 3}, .direction = {0, 0, -1}};
  const Ray from_behind{.origin = {0.1, 0.2, -3}, .direction = {0, 0, 1}};
  CHECK(accel.closest(from_front, scratch));
  CHECK_FALSE(accel.closest(from_behind, scratch));
  CHECK(accel.transmittance(from_front, 9, scratch) == glm::vec3(0.0f));
  CHECK(accel.transmittance(from_behind, 9, scratch) == glm::vec3(0.0f));
}

TEST_CASE("behind a back face that is not seen are solids and other meshes", "[tracer][accel]") {
  SceneBuilder builder;
  const MaterialId paper = builder.material({.single_sided = true});
  builder.mesh("sheet", square(1.0), at(0, 0, 1), paper)
      .mesh("other sheet", square(0.5), at(0, 0, 2), paper)
      .mesh("turned sheet", square(0.3), glm::scale(at(0, 0, 3), glm::dvec3(1, 1, -1)), paper)
      .shape("wall", Box{.size = {9, 9, 1}}, at(0, 0, 9), paper);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch scratch;
  const auto met = [&](double x) {
    const auto hit = accel.closest({.origin = {x, 0.1, -5}, .direction = {0, 0, 1}}, scratch);
    return scene.surfaces.name(scene.surfaces.object(hit.value().surface));
  };
  CHECK(met(0.1) == "turned sheet");
  CHECK(met(0.4) == "wall");
  CHECK(met(2.0) == "wall");
  // A solid's inside is seen, whatever the material.
  CHECK(accel.closest({.origin = {0, 0, 9}, .direction = {0, 0, 1}}, scratch));
}

TEST_CASE("an empty scene has nothing to hit", "[tracer][accel]") {
  const Scene scene;
  const Accel accel(scene);
  Solid::Scratch scratch;
  CHECK_FALSE(accel.closest({}, scratch));
  CHECK(accel.transmittance({}, 9, scratch) == glm::vec3(1.0f));
}

}  // namespace
}  // namespace raycat
