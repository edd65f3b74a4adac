#include "tracer/tracer.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "support/scenes.hpp"
#include "tracer/pbr.hpp"

namespace raycat {
namespace {

struct Traced {
  glm::vec3 colour;
  RayTree tree;
  RayCounts rays;
};

Traced trace_one(const Scene& scene, const Ray& ray, int levels = 8) {
  const Accel accel(scene);
  TraceScratch scratch;
  Traced traced{};
  traced.colour = trace(accel, ray, levels, traced.tree, scratch);
  traced.rays = scratch.rays;
  return traced;
}

constexpr double diagonal = 0.70710678118654752;
constexpr double quarter_turn = 1.5707963267948966;

const Ray down{.origin = {0, 5, 0}, .direction = {0, -1, 0}};

Light sun(const glm::dvec3& direction) {
  return {.name = "sun",
          .kind = Light::Kind::directional,
          .direction = glm::normalize(direction),
          .diffuse = {0.8f, 0.6f, 0.4f},
          .specular = {0.5f, 0.25f, 1.0f}};
}

TEST_CASE("a hit is shaded by eq. (1)", "[tracer][shading]") {
  SceneBuilder builder;
  const MaterialId stone = builder.material({.emission = {0.01f, 0.02f, 0.03f},
                                             .ambient = {0.1f, 0.2f, 0.3f},
                                             .diffuse = {0.5f, 0.25f, 1.0f},
                                             .specular = {1.0f, 0.5f, 0.25f},
                                             .shininess = 2.0f});
  builder.shape("ground", HalfSpace{}, at(0, 0, 0), stone).light(sun({1, -1, 0}));
  Scene scene = builder.take();
  scene.ambient_light = {0.5f, 0.5f, 0.5f};
  const Traced traced = trace_one(scene, down);
  // N.L is cos 45; H lies halfway between the light and the eye, so N.H is cos 22.5.
  const double lambert = diagonal;
  const double halfway = std::pow(std::cos(0.39269908169872414), 2.0);
  CHECK(traced.colour.r ==
        Approx(0.01 + 0.1 * 0.5 + 0.5 * 0.8 * lambert + 1.0 * 0.5 * halfway).epsilon(1e-5));
  CHECK(traced.colour.g ==
        Approx(0.02 + 0.2 * 0.5 + 0.25 * 0.6 * lambert + 0.5 * 0.25 * halfway).epsilon(1e-5));
  CHECK(traced.colour.b ==
        Approx(0.03 + 0.3 * 0.5 + 1.0 * 0.4 * lambert + 0.25 * 1.0 * halfway).epsilon(1e-5));
  CHECK(traced.tree == RayTree{{.position = 1, .lights = 1, .surface = SurfaceId{0}}});
}

TEST_CASE("a light is visible when it is in front and nothing is between", "[tracer][lights]") {
  SceneBuilder builder;
  const MaterialId stone = builder.material({.diffuse = glm::vec3(1.0f)});
  builder.shape("ground", HalfSpace{}, at(0, 0, 0), stone)
      .shape("shade", Box{.size = {1, 1, 1}}, at(-3, 3, 0), stone)
      .light(sun({0, -1, 0}))                        // bit 0: straight above
      .light(sun({0, 1, 0}))                         // bit 1: from below
      .light(sun({1, -1, 0}))                        // bit 2: from where the box is
      .light({.position = {-6, 6, 0}})               // bit 3: behind the box
      .light({.position = {-1, 1, 0}})               // bit 4: before the box
      .light({.position = {0, 2, 0}, .range = 1.5})  // bit 5: too far
      .light({.kind = Light::Kind::spot, .position = {0, 2, 0}, .direction = {0, -1, 0}})
      .light({.kind = Light::Kind::spot, .position = {2, 1, 0}, .direction = {0, -1, 0}});
  const Traced traced = trace_one(builder.take(), down);
  REQUIRE(traced.tree.size() == 1);
  CHECK(traced.tree[0].lights == (1u << 0 | 1u << 4 | 1u << 6));
}

// Does the sun above count where a ray falls on a square of this material?
bool counts(const Material& material, CountedLights counted = CountedLights::lighting) {
  SceneBuilder builder;
  builder.mesh("square", square(1.0), at(0, 0, 0), builder.material(material))
      .light(sun({0, 0, -1}));
  Scene scene = builder.take();
  scene.counted_lights = counted;
  scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>{0, 0, 0, 0});
  const Ray ray{.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}};
  const Traced traced = trace_one(scene, ray);
  const bool lit = traced.tree.back().lights == 1;
  const Accel accel(scene);
  TraceScratch scratch;
  CHECK(reaches(accel, ray, *accel.closest(ray, scratch.solid), 0, scratch) == lit);
  CHECK(traced.rays.shadow == (lit ? 1u : 0u));
  return lit;
}

TEST_CASE("a light counts where O_d or O_s lets it contribute", "[tracer][lights]") {
  const Material unlit{
      .emission = glm::vec3(1.0f), .ambient = glm::vec3(1.0f), .reflection = glm::vec3(1.0f)};
  CHECK_FALSE(counts(unlit));
  CHECK_FALSE(counts({.transmission = glm::vec3(1.0f), .ior = 1.5f}));
  CHECK(counts(unlit, CountedLights::visible));
  CHECK(counts({.diffuse = {0.0f, 0.0f, 1e-6f}}));
  CHECK(counts({.specular = {0.0f, 1e-6f, 0.0f}}));
  // Nothing is left of what is not there at all.
  const Material veil{.diffuse = glm::vec3(1.0f), .thin = true, .blend = true, .alpha = 0.5f};
  Material gone = veil;
  gone.alpha = 0.0f;
  CHECK(counts(veil));
  CHECK_FALSE(counts(gone));
  CHECK(counts(gone, CountedLights::visible));
}

TEST_CASE("no texel decides whether a light counts", "[tracer][lights]") {
  // The texture is black, and its alpha nothing.
  CHECK(counts({.diffuse = glm::vec3(1.0f), .base_texture = TextureMap{}}));
  CHECK(counts({.diffuse = glm::vec3(1.0f),
                .transmission = glm::vec3(1.0f),
                .thin = true,
                .base_texture = TextureMap{},
                .blend = true}));
  const auto varying = [](VaryingPbr pbr) {
    Material material = whitted(pbr.factors);
    material.varying = std::make_shared<const VaryingPbr>(std::move(pbr));
    return counts(material);
  };
  // Black metal is black; where a texture says what is metal, it may be bright plastic.
  CHECK_FALSE(varying({.factors = {.base = glm::dvec3(0.0)}}));
  CHECK(varying({.factors = {.base = glm::dvec3(0.0)}, .metallic_roughness = TextureMap{}}));
  const Pbr clear{.metallic = 0.0, .specular = 0.0, .transmission = 1.0};
  CHECK_FALSE(varying({.factors = clear}));
  CHECK(varying({.factors = clear, .transmission = TextureMap{}}));
}

TEST_CASE("a mirror does not show the backs of what is single-sided, but their shadows",
          "[tracer][reflection]") {
  const auto traced = [](bool single_sided) {
    SceneBuilder builder;
    const MaterialId mirror =
        builder.material({.diffuse = glm::vec3(0.5f), .reflection = glm::vec3(1.0f)});
    const MaterialId paper =
        builder.material({.emission = {1, 0, 0}, .single_sided = single_sided});
    // Seen from above, the sheet over the mirror turns its front up.
    builder.shape("mirror", HalfSpace{}, at(0, 0, 0), mirror)
        .mesh("sheet", square(1.0), glm::rotate(at(0, 2, 0), -quarter_turn, glm::dvec3(1, 0, 0)),
              paper)
        .light(sun({0, -1, 0}));
    // Below the sheet, down to the mirror and up to the back of the sheet.
    return trace_one(builder.take(), {.origin = {1.2, 1, 0}, .direction = {-0.5, -1, 0}});
  };
  const Traced shown = traced(false);
  REQUIRE(shown.tree.size() == 2);
  CHECK(shown.tree[1].lights == 0);
  const Traced hidden = traced(true);
  REQUIRE(hidden.tree.size() == 1);
  CHECK(hidden.tree[0].lights == 0);
}

// A ball of flat triangles with the normals of a round one.
SurfaceMesh coarse_ball() {
  constexpr std::uint32_t around = 12;
  constexpr std::uint32_t rings = 7;
  SurfaceMesh mesh;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    for (std::uint32_t k = 0; k <= around; ++k) {
      const double polar = 3.141592653589793 * ring / rings;
      const double turn = 6.283185307179586 * k / around;
      const glm::dvec3 p(std::sin(polar) * std::cos(turn), std::cos(polar),
                         -std::sin(polar) * std::sin(turn));
      mesh.triangles.positions.push_back(p);
      mesh.normals.emplace_back(p);
      if (ring > 0 && k > 0) {
        const std::uint32_t d = ring * (around + 1) + k;
        const std::uint32_t b = d - around - 1;
        mesh.triangles.triangles.emplace_back(b - 1, d - 1, d);
        mesh.triangles.triangles.emplace_back(b - 1, d, b);
      }
    }
  }
  mesh.triangles.faces.assign(mesh.triangles.triangles.size(), 0);
  mesh.triangles.face_count = 1;
  return mesh;
}

TEST_CASE("light ends on a smooth mesh where its normals turn away, not triangle by triangle",
          "[tracer][lights]") {
  SceneBuilder builder;
  builder.mesh("ball", coarse_ball(), at(0, 0, 0), builder.material({.diffuse = glm::vec3(1.0f)}))
      .light(sun({-1, -0.4, 0.3}));
  const Scene scene = builder.take();
  const glm::dvec3 towards = -scene.lights[0].direction;
  const Accel accel(scene);
  TraceScratch scratch;
  int tried = 0;
  int wrong = 0;
  for (double x = -0.9; x < 0.9; x += 0.013) {
    for (double y = -0.9; y < 0.9; y += 0.017) {
      const Ray ray{.origin = {x, y, 5}, .direction = {0, 0, -1}};
      const auto hit = accel.closest(ray, scratch.solid);
      if (!hit) {
        continue;
      }
      const glm::uvec3 i = hit->mesh->mesh->triangles.triangles[hit->triangle];
      const auto& normals = hit->mesh->mesh->normals;
      const glm::dvec2 v = hit->barycentric;
      const glm::dvec3 normal = (1.0 - v.x - v.y) * glm::dvec3(normals[i.x]) +
                                v.x * glm::dvec3(normals[i.y]) + v.y * glm::dvec3(normals[i.z]);
      const bool lit = shade(accel, ray, *hit, Media(), false, scratch).lights != 0;
      ++tried;
      wrong += lit == (glm::dot(normal, towards) > 0.0) ? 0 : 1;
    }
  }
  CHECK(tried > 8000);
  CHECK(wrong == 0);
}

TEST_CASE("glTF's lights fall off with distance, range and cone", "[tracer][lights]") {
  const auto lit_by = [](const Light& light) {
    SceneBuilder builder;
    builder
        .shape("ground", HalfSpace{}, at(0, 0, 0), builder.material({.diffuse = glm::vec3(1.0f)}))
        .light(light);
    return static_cast<double>(trace_one(builder.take(), down).colour.r);
  };
  CHECK(lit_by({.position = {0, 4, 0}}) == Approx(1.0));
  CHECK(lit_by({.position = {0, 4, 0}, .inverse_square = true}) == Approx(1.0 / 16));
  CHECK(lit_by({.position = {0, 4, 0}, .inverse_square = true, .range = 8}) ==
        Approx((1.0 - 1.0 / 16) / 16));
  // Halfway in cosine between the cones: (1/2)^2.
  const double outer = std::acos(0.6);
  const double inner = std::acos(1.0);
  const glm::dvec3 aside(0.6, -0.8, 0);
  CHECK(lit_by({.kind = Light::Kind::spot,
                .position = {0, 4, 0},
                .direction = aside,
                .inner_cone = inner,
                .outer_cone = outer}) == Approx(0.25).epsilon(1e-4));
}

TEST_CASE("mirrors reflect down to the last level", "[tracer][reflection]") {
  SceneBuilder builder;
  const MaterialId mirror = builder.material({.reflection = {0.5f, 0.25f, 1.0f}});
  builder.shape("floor", Box{.size = {9, 1, 9}}, at(0, -0.5, 0), mirror)
      .shape("ceiling", Box{.size = {9, 1, 9}}, at(0, 10.5, 0), mirror);
  const Scene scene = builder.take();
  const int levels = GENERATE(1, 2, 5);
  const Traced traced = trace_one(scene, down, levels);
  REQUIRE(traced.tree.size() == static_cast<std::size_t>(levels));
  CHECK(traced.rays.reflection == static_cast<std::uint64_t>(levels - 1));
  // Deepest first; each is the reflection of the one after it.
  for (int k = 0; k < levels; ++k) {
    const RayNode& node = traced.tree[static_cast<std::size_t>(levels - 1 - k)];
    CHECK(node.position == (HeapPosition{2} << k) - 1);
    CHECK(node.weight == 1.0f);
  }
}

TEST_CASE("what no level meets is the background, weighted", "[tracer][reflection]") {
  SceneBuilder builder;
  const MaterialId mirror = builder.material({.reflection = {0.5f, 0.25f, 1.0f}});
  builder.shape("floor", HalfSpace{}, at(0, 0, 0), mirror);
  Scene scene = builder.take();
  scene.background = {0.2f, 0.4f, 0.8f};
  CHECK(trace_one(scene, down).colour == glm::vec3(0.1f, 0.1f, 0.8f));
}

Scene glass_over(const Shape& shape, float ior) {
  SceneBuilder builder;
  const MaterialId glass = builder.material({.transmission = glm::vec3(0.5f), .ior = ior});
  const MaterialId stone = builder.material({.emission = {1, 0, 0}});
  builder.shape("glass", shape, at(0, 0, 0), glass)
      .shape("wall", Box{.size = {99, 1, 99}}, at(0, -10.5, 0), stone);
  return builder.take();
}

TEST_CASE("what absorbs weakens light by the way inside (Beer's law)", "[tracer][refraction]") {
  SceneBuilder builder;
  const MaterialId murky = builder.material(
      {.transmission = glm::vec3(1.0f), .ior = 1.0f, .absorption = {0.25f, 0.0f, 1.0f}});
  const MaterialId stone = builder.material({.emission = {1, 1, 1}});
  builder.shape("plate", Box{.size = {50, 2, 50}}, at(0, 0, 0), murky)
      .shape("wall", Box{.size = {99, 1, 99}}, at(0, -10.5, 0), stone);
  const Scene scene = builder.take();
  // Aslant by 60 degrees, so that the way through a height of 2 is 4; rays need not have length 1.
  const glm::dvec3 way(std::sin(1.0471975511965976), -0.5, 0.0);
  const glm::vec3 colour = trace_one(scene, {.origin = {0, 5, 0}, .direction = 3.0 * way}).colour;
  CHECK(colour.r == Approx(std::exp(-1.0)).epsilon(1e-5));
  CHECK(colour.g == Approx(1.0));
  CHECK(colour.b == Approx(std::exp(-4.0)).epsilon(1e-5));
}

TEST_CASE("a plate moves a ray aside and keeps its direction (Snell)", "[tracer][refraction]") {
  // 45 degrees into a plate of height 2 and index 1.5, then on to the wall at y = -10.
  const Scene scene = glass_over(Box{.size = {50, 2, 50}}, 1.5f);
  const Accel accel(scene);
  Solid::Scratch solid;
  TraceScratch scratch;
  const Ray ray{.origin = {-1, 2, 0}, .direction = {diagonal, -diagonal, 0}};
  const Hit in = *accel.closest(ray, solid);
  const Shading first = shade(accel, ray, in, Media(), true, scratch);
  REQUIRE(first.refraction);
  CHECK(glm::dvec3(first.refraction->direction).x == Approx(diagonal / 1.5));
  CHECK(first.media.ior() == 1.5f);
  CHECK_FALSE(first.reflection);
  const Hit out = *accel.closest(*first.refraction, solid);
  const Shading second = shade(accel, *first.refraction, out, first.media, true, scratch);
  REQUIRE(second.refraction);
  CHECK(second.refraction->direction.x == Approx(diagonal));
  CHECK(second.media.ior() == 1.0f);
  const double within = std::tan(std::asin(diagonal / 1.5));
  const Hit wall = *accel.closest(*second.refraction, solid);
  CHECK(second.refraction->at(wall.t).x == Approx(2 * within + 9.0).epsilon(1e-9));
}

TEST_CASE("total internal reflection sends all light with the reflected ray",
          "[tracer][refraction]") {
  // Up inside a plate of index 1.5 at 60 degrees, past the critical angle of 41.8.
  const Scene scene = glass_over(Box{.size = {50, 2, 50}}, 1.5f);
  const double s = std::sin(1.0471975511965976);
  const Ray ray{.origin = {0, 0, 0}, .direction = {s, 0.5, 0}};
  const Accel accel(scene);
  Solid::Scratch solid;
  TraceScratch scratch;
  const Shading shading = shade(accel, ray, *accel.closest(ray, solid),
                                Media().entered(ObjectId{0}, 1.5f), true, scratch);
  CHECK_FALSE(shading.refraction);
  REQUIRE(shading.reflection);
  CHECK(shading.k_s == glm::vec3(0.5f));
  CHECK(shading.reflection_weight == 0.5f);
  CHECK(shading.reflection->direction.y == Approx(-0.5));
}

TEST_CASE("a ray tree lists the refraction subtree, the reflection subtree, the node",
          "[tracer][recording]") {
  SceneBuilder builder;
  const MaterialId glass = builder.material(
      {.reflection = glm::vec3(0.25f), .transmission = glm::vec3(0.5f), .ior = 1.0f});
  const MaterialId stone = builder.material({});
  // One pane of a single triangle pair, a wall behind it and one before.
  builder.mesh("pane", square(1.0), at(0, 0, 0), glass)
      .shape("behind", Box{.size = {9, 9, 1}}, at(0, 0, -5), stone)
      .shape("before", Box{.size = {9, 9, 1}}, at(0, 0, 9), stone);
  const Traced traced =
      trace_one(builder.take(), {.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}});
  REQUIRE(traced.tree.size() == 3);
  CHECK(traced.tree[0] == RayNode{.position = 2, .surface = SurfaceId{1 + 5}});
  CHECK(traced.tree[0].weight == 0.5f);
  CHECK(traced.tree[1] == RayNode{.position = 3, .surface = SurfaceId{7 + 4}});
  CHECK(traced.tree[1].weight == 0.25f);
  CHECK(traced.tree[2] == RayNode{.position = 1, .surface = SurfaceId{0}});
  CHECK(traced.tree[2].weight == 1.0f);
}

TEST_CASE("Schlick's weights never decide whether a ray exists", "[tracer][fresnel]") {
  SceneBuilder builder;
  const MaterialId glass = builder.material({.reflection = glm::vec3(0.04f),
                                             .transmission = glm::vec3(0.96f),
                                             .ior = 1.5f,
                                             .fresnel = true,
                                             .grazing_reflection = glm::vec3(1.0f)});
  builder.shape("glass", Box{.size = {200, 2, 200}}, at(0, 0, 0), glass);
  const Scene scene = builder.take();
  const Accel accel(scene);
  Solid::Scratch solid;
  TraceScratch scratch;
  const auto shaded = [&](double angle) {
    const Ray ray{.origin = {0, 2, 0}, .direction = {std::sin(angle), -std::cos(angle), 0}};
    return shade(accel, ray, *accel.closest(ray, solid), Media(), true, scratch);
  };
  const Shading square_on = shaded(0.0);
  CHECK(square_on.k_s.r == Approx(0.04));
  CHECK(square_on.k_t.r == Approx(0.96));
  const Shading grazing = shaded(1.55);
  CHECK(grazing.k_s.r > 0.85);
  CHECK(grazing.k_s.r + grazing.k_t.r == Approx(1.0).margin(0.01));
  CHECK((grazing.refraction && grazing.reflection));
  CHECK(grazing.reflection_weight == square_on.reflection_weight);
}

TEST_CASE("a texture changes colours and no branch", "[tracer][texture]") {
  const auto with = [](std::uint8_t grey) {
    SceneBuilder builder;
    const MaterialId tile = builder.material(
        {.diffuse = glm::vec3(1.0f), .reflection = glm::vec3(0.5f), .base_texture = TextureMap{}});
    builder.mesh("tile", square(1.0), at(0, 0, 0), tile).light(sun({0, 0, -1}));
    Scene scene = builder.take();
    scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>{grey, grey, grey, 255});
    return trace_one(scene, {.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}});
  };
  const Traced black = with(0);
  const Traced white = with(255);
  CHECK(white.colour.r == Approx(black.colour.r + 0.8));
  CHECK(white.tree == black.tree);
  CHECK(white.rays.reflection == 1);
  CHECK(black.rays.reflection == 1);
}

TEST_CASE("blended surfaces let the rest through in a straight line", "[tracer][blend]") {
  SceneBuilder builder;
  const MaterialId veil = builder.material({.emission = {1, 1, 1},
                                            .transmission = glm::vec3(0.75f),
                                            .ior = 1.5f,
                                            .thin = true,
                                            .blend = true,
                                            .alpha = 0.25f});
  builder.mesh("veil", square(1.0), at(0, 0, 0), veil);
  Scene scene = builder.take();
  scene.background = {0.4f, 0.0f, 0.0f};
  const Traced traced = trace_one(scene, {.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}});
  CHECK(traced.colour.r == Approx(0.25 + 0.75 * 0.4));
  CHECK(traced.colour.g == Approx(0.25));
}

TEST_CASE("recording changes nothing in the picture", "[tracer][recording]") {
  const Scene scene = glass_over(Sphere{.radius = 1.0}, 1.5f);
  const Accel accel(scene);
  TraceScratch scratch;
  RayTree tree;
  NoRecord nothing;
  for (double x = -1.2; x < 1.2; x += 0.01) {
    const Ray ray{.origin = {x, 5, 0.1}, .direction = {0, -1, 0}};
    CHECK(trace(accel, ray, 8, tree, scratch) == trace(accel, ray, 8, nothing, scratch));
  }
}

}  // namespace
}  // namespace raycat
