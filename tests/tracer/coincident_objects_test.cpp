#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/coincident_twins.hpp"
#include "geometry/mesh.hpp"
#include "geometry/sample_meshes.hpp"
#include "raytree/ray_tree.hpp"
#include "support/scenes.hpp"
#include "tracer/tracer.hpp"

namespace raycat {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

SurfaceMesh box_mesh(const glm::dvec3& low, const glm::dvec3& high) {
  return {.triangles = test::box(low, high)};
}

enum class As : std::uint8_t { box, polyhedron, mesh };

As any_of_them() { return GENERATE(As::box, As::polyhedron, As::mesh); }

// A box from `low` to `high`.
void add_box(SceneBuilder& builder, As as, const std::string& name, const glm::dvec3& low,
             const glm::dvec3& high, const glm::dmat4& place, MaterialId material) {
  if (as == As::mesh) {
    builder.mesh(name, box_mesh(low, high), place, material);
  } else if (as == As::polyhedron) {
    builder.shape(name, std::make_shared<const ClosedMesh>(test::box(low, high)), place, material);
  } else {
    builder.shape(name, Box{.size = high - low}, glm::translate(place, 0.5 * (low + high)),
                  material);
  }
}

// Some place that no coordinate is exact in.
glm::dmat4 anywhere(std::mt19937& random, double size) {
  const glm::dvec3 axis(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  const glm::dvec3 to(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -9, 9));
  return glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), size * to), uniform(random, 0, 6),
                                glm::normalize(axis)),
                    glm::dvec3(size));
}

struct Traced {
  glm::vec3 colour{0.0f};
  RayTree tree;
};

Traced trace_at(const Accel& accel, const Ray& ray, int levels) {
  Traced out;
  TraceScratch scratch;
  out.colour = trace(accel, ray, levels, out.tree, scratch);
  return out;
}

std::vector<std::uint32_t> objects(const Scene& scene, const RayTree& tree) {
  std::vector<std::uint32_t> out;
  for (std::size_t i = tree.size(); i-- > 0;) {
    out.push_back(static_cast<std::uint32_t>(scene.surfaces.object(tree[i].surface)));
  }
  return out;
}

// Half the light, straight on.
Material clear(float ior) { return {.transmission = glm::vec3(0.5f), .ior = ior}; }

Ray in(const glm::dmat4& place, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 origin(place * glm::dvec4(from, 1.0));
  return {.origin = origin, .direction = glm::dvec3(place * glm::dvec4(to, 1.0)) - origin};
}

TEST_CASE("a glass that stands on a floor is left before the floor is met",
          "[tracer][coincident]") {
  const As glass_as = any_of_them();
  const As floor_as = any_of_them();
  const double size = GENERATE(1.0, 1e-4, 1e5);
  std::mt19937 random(7);
  for (int turn = 0; turn < 8; ++turn) {
    const glm::dmat4 place = anywhere(random, size);
    SceneBuilder builder;
    const MaterialId glass = builder.material(clear(1.5f));
    const MaterialId stone =
        builder.material({.diffuse = glm::vec3(1.0f), .specular = glm::vec3(0.0f)});
    add_box(builder, floor_as, "floor", {-3, -1, -3}, {3, 0, 3}, place, stone);
    add_box(builder, glass_as, "glass", {-1, 0, -1}, {1, 1, 1}, place, glass);
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.direction = glm::normalize(glm::dvec3(place * glm::dvec4(0, -1, 0, 0)));
    builder.light(sun);
    const Scene scene = builder.take();
    const Accel accel(scene);
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 on(uniform(random, -0.9, 0.9), 0.0, uniform(random, -0.9, 0.9));
      const glm::dvec3 aside(uniform(random, -0.05, 0.05), 5.0, uniform(random, -0.05, 0.05));
      const Traced traced = trace_at(accel, in(place, on + aside, on), 5);
      REQUIRE(objects(scene, traced.tree) == std::vector<std::uint32_t>{1, 1, 0});
      // Through the glass twice, by two faces each time, with the sun overhead.
      REQUIRE(traced.tree[0].lights == 1);
      REQUIRE(traced.colour.r == Approx(0.0625f).epsilon(1e-3));
    }
  }
}

TEST_CASE("where glass touches water, a ray goes straight from the one into the other",
          "[tracer][coincident]") {
  const As glass_as = any_of_them();
  const As water_as = any_of_them();
  const bool water_first = GENERATE(false, true);
  std::mt19937 random(11);
  for (int turn = 0; turn < 8; ++turn) {
    const glm::dmat4 place = anywhere(random, 1.0);
    SceneBuilder builder;
    const MaterialId glass = builder.material(clear(1.5f));
    const MaterialId water = builder.material(clear(1.33f));
    const MaterialId stone = builder.material({.emission = glm::vec3(1.0f)});
    const auto add_water = [&] {
      add_box(builder, water_as, "water", {-9, -1, -9}, {9, 0, 9}, place, water);
    };
    if (water_first) {
      add_water();
    }
    add_box(builder, glass_as, "glass", {-9, 0, -9}, {9, 1, 9}, place, glass);
    if (!water_first) {
      add_water();
    }
    add_box(builder, As::box, "stone", {-99, -9, -99}, {99, -8, 99}, place, stone);
    const Scene scene = builder.take();
    const Accel accel(scene);
    TraceScratch scratch;
    const std::uint32_t of_glass = water_first ? 1 : 0;
    for (int i = 0; i < 40; ++i) {
      // At up to 85 degrees from above: from glass into air it would be reflected.
      const double angle = uniform(random, 0.0, 1.48);
      const Ray ray =
          in(place, {-3.0, 1.5, 0.5}, {-3.0 + std::sin(angle), 1.5 - std::cos(angle), 0.5});
      const glm::dvec3 down = glm::normalize(glm::dvec3(place * glm::dvec4(0, -1, 0, 0)));
      const double sine = std::sin(angle);
      ChildRay at{ray, {}};
      Media media;
      const std::vector<std::uint32_t> expected{of_glass, of_glass, 1 - of_glass, 1 - of_glass, 2};
      const std::vector<double> after{1.5, 1.33, 1.33, 1.0};  // the medium behind each
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const auto hit = accel.closest(at, scratch.solid, at.from);
        REQUIRE(hit);
        REQUIRE(static_cast<std::uint32_t>(scene.surfaces.object(hit->surface)) == expected[k]);
        if (k == after.size()) {
          break;
        }
        const Shading shading = spawn(accel, at, *hit, media, scratch);
        REQUIRE(shading.refraction);
        REQUIRE(std::sqrt(1.0 - std::pow(glm::dot(shading.refraction->direction, down), 2.0)) ==
                Approx(sine / after[k]).margin(1e-6));
        at = *shading.refraction;
        media = shading.media;
      }
    }
  }
}

TEST_CASE("water that overlaps its glass somewhat is entered from the glass",
          "[tracer][refraction]") {
  SceneBuilder builder;
  const MaterialId glass = builder.material(clear(1.5f));
  const MaterialId water = builder.material(clear(1.33f));
  builder.shape("glass", Box{.size = {20, 1, 20}}, at(0, 0.5, 0), glass)
      .shape("water", Box{.size = {20, 1, 20}}, at(0, -0.4, 0), water);  // up to 0.1
  const Scene scene = builder.take();
  const Accel accel(scene);
  TraceScratch scratch;
  ChildRay ray{{.origin = {0, 2, 0}, .direction = {0.8, -0.6, 0}}, {}};
  Media media;
  for (const double index : {1.5, 1.33, 1.33, 1.0}) {
    const auto hit = accel.closest(ray, scratch.solid, ray.from);
    REQUIRE(hit);
    const Shading shading = spawn(accel, ray, *hit, media, scratch);
    REQUIRE(shading.refraction);
    CHECK(shading.refraction->direction.x == Approx(0.8 / index).epsilon(1e-7));
    ray = *shading.refraction;
    media = shading.media;
  }
}

TEST_CASE("of opaque surfaces in one plane the first is seen, and what light passes in front of it",
          "[tracer][coincident]") {
  const As wall_as = any_of_them();
  const double size = GENERATE(1.0, 1e6);
  std::mt19937 random(13);
  for (int turn = 0; turn < 8; ++turn) {
    const glm::dmat4 place = anywhere(random, size);
    SceneBuilder builder;
    const MaterialId stone = builder.material({.emission = glm::vec3(1.0f)});
    const MaterialId ink = builder.material({.transmission = glm::vec3(0.5f), .thin = true});
    builder.mesh("sign", square(1.0), place * at(-2, 0, 0), stone);
    add_box(builder, wall_as, "wall", {-9, -9, -1}, {9, 9, 0}, place, stone);
    builder.mesh("late sign", square(1.0), place * at(2, 0, 0), stone);
    builder.mesh("decal", square(1.0), place * at(0, 3, 0), ink);
    const Scene scene = builder.take();
    const Accel accel(scene);
    const auto seen = [&](double x, double y) {
      const glm::dvec3 on(x, y, 0);
      const glm::dvec3 from(x + uniform(random, -9, 9), y + uniform(random, -9, 9), 9);
      return objects(scene, trace_at(accel, in(place, from, on), 4).tree);
    };
    for (int i = 0; i < 50; ++i) {
      const double u = uniform(random, -0.99, 0.99);
      const double v = uniform(random, -0.99, 0.99);
      REQUIRE(seen(u - 2, v) == std::vector<std::uint32_t>{0});
      REQUIRE(seen(u + 2, v) == std::vector<std::uint32_t>{1});
      REQUIRE(seen(u, v + 3) == std::vector<std::uint32_t>{3, 1});
      REQUIRE(seen(u, v - 4) == std::vector<std::uint32_t>{1});
    }
  }
}

TEST_CASE("a camera on a face looks through it", "[tracer][coincident]") {
  const As as = any_of_them();
  std::mt19937 random(17);
  for (int turn = 0; turn < 20; ++turn) {
    const glm::dmat4 place = anywhere(random, std::pow(10.0, turn % 5 - 2));
    SceneBuilder builder;
    const MaterialId stone = builder.material({});
    add_box(builder, as, "box", {-1, -1, -1}, {1, 1, 1}, place, stone);
    const Scene scene = builder.take();
    const Accel accel(scene);
    Solid::Scratch scratch;
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 eye(uniform(random, -1, 1), 1.0, uniform(random, -1, 1));
      const glm::dvec3 inside(uniform(random, -0.9, 0.9), uniform(random, -0.9, 0.9),
                              uniform(random, -0.9, 0.9));
      const auto hit = accel.closest(in(place, eye, inside), scratch);
      REQUIRE(hit);
      CHECK_FALSE(hit->entering);  // the far side
      CHECK_FALSE(accel.closest(in(place, eye, 2.0 * eye - inside), scratch));
    }
  }
}

TEST_CASE("of triangles stored twice the one that faces the ray is met, once", "[tracer][twins]") {
  SceneBuilder builder;
  const MaterialId ink = builder.material({.transmission = glm::vec3(0.5f)});
  SurfaceMesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  const std::size_t count = mesh.triangles.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::uvec3 t = mesh.triangles.triangles[i];
    mesh.triangles.triangles.emplace_back(t.x, t.z, t.y);
    mesh.triangles.faces.push_back(mesh.triangles.faces[i]);
  }
  mesh.twins = coincident_twins(mesh.triangles.positions, mesh.triangles.triangles);
  std::mt19937 random(19);
  const glm::dmat4 place = anywhere(random, 1.0);
  builder.mesh("box", std::move(mesh), place, ink);
  const Scene scene = builder.take();
  const Accel accel(scene);
  TraceScratch scratch;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 to(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    const Ray ray = in(place, 5.0 * glm::normalize(to), 0.3 * to);
    const Traced traced = trace_at(accel, ray, 6);
    REQUIRE(traced.tree.size() == 2);  // in and out
    CHECK(traced.colour.r == Approx(0.25f * scene.background.r));
    const auto hit = accel.closest(ray, scratch.solid);
    CHECK(hit->entering);
    CHECK(glm::dot(hit->normal, ray.direction) < 0.0);
    CHECK(accel.transmittance(ray, 1e3, scratch.solid).r == 0.25f);
  }
}

// One ray with all that follows it, the same for a scene of meshes as for one of solids.
std::vector<std::uint32_t> path(const Scene& scene, const Ray& ray) {
  const Accel accel(scene);
  return objects(scene, trace_at(accel, ray, 8).tree);
}

TEST_CASE("a pane of 2 mm, 5 km out, has a far side", "[tracer][far]") {
  const As as = any_of_them();
  const double turned = GENERATE(0.0, 0.3);
  SceneBuilder builder;
  const MaterialId glass = builder.material(clear(1.5f));
  const MaterialId stone = builder.material({});
  const glm::dmat4 place = glm::rotate(at(0, 0, -5000), turned, glm::dvec3(1, 2, 0.5));
  add_box(builder, as, "pane", {-1, -1, -0.001}, {1, 1, 0.001}, place, glass);
  builder.shape("wall", Box{.size = {50, 50, 1}}, at(0, 0, -5010), stone)
      .shape("here", Box{.size = {1, 1, 1}}, at(0, 0, 3), stone);
  const Scene scene = builder.take();
  std::mt19937 random(23);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 to(uniform(random, -0.8, 0.8), uniform(random, -0.8, 0.8), -5000);
    CHECK(path(scene, {.origin = {0, 0, 0}, .direction = to}) ==
          std::vector<std::uint32_t>{0, 0, 1});
  }
}

TEST_CASE("small things stand on a floor of a million units with their shadows", "[tracer][far]") {
  const double size = GENERATE(1.0, 1e-3);  // a ratio of 1e9 to the floor
  const double away = GENERATE(0.0, 3e5);
  const double turned = GENERATE(0.0, 0.7);
  const glm::dmat4 world = glm::rotate(glm::dmat4(1.0), turned, glm::dvec3(1, 2, 3));
  SceneBuilder builder;
  const MaterialId stone = builder.material({.diffuse = glm::vec3(1.0f)});
  builder.mesh("floor", square(5e5), world, stone);
  const glm::dmat4 place = world * glm::scale(at(away, 0, 0), glm::dvec3(size));
  builder.mesh("box", box_mesh({-1, -1, 0}, {1, 1, 1}), place, stone);
  Light sun;
  sun.kind = Light::Kind::directional;
  sun.direction = glm::normalize(glm::dvec3(world * glm::dvec4(1, 0, -1, 0)));
  builder.light(sun);
  const Scene scene = builder.take();
  const Accel accel(scene);
  std::mt19937 random(29);
  for (int i = 0; i < 200; ++i) {
    // The box's shadow reaches from x = 1 to 2.
    const double x = uniform(random, 1.001, 3.0);
    const glm::dvec3 on(x, uniform(random, -0.99, 0.99), 0.0);
    const Traced traced = trace_at(accel, in(place, on + glm::dvec3(2, 0, 3), on), 1);
    REQUIRE(objects(scene, traced.tree) == std::vector<std::uint32_t>{0});
    CAPTURE(size, away, turned, x, on.y);
    CHECK(traced.tree[0].lights == (x < 2.0 ? 0 : 1));
    const glm::dvec3 top(uniform(random, -0.99, 0.99), uniform(random, -0.99, 0.99), 1.0);
    const Traced lit = trace_at(accel, in(place, top + glm::dvec3(2, 0, 3), top), 1);
    CHECK(objects(scene, lit.tree) == std::vector<std::uint32_t>{1});
    CHECK(lit.tree[0].lights == 1);
  }
}

}  // namespace
}  // namespace raycat
