#include "tracer/material_at.hpp"

#include <array>
#include <vector>

#include <catch2/catch.hpp>

#include "support/scenes.hpp"

namespace raycat {
namespace {

constexpr MeshPoint middle(const SurfaceMesh& mesh) {
  return {.mesh = mesh, .triangle = 0, .barycentric = {0.25, 0.25}};
}

// A scene whose textures are of one texel each: red, green, blue, alpha.
Scene texels(const std::vector<std::array<std::uint8_t, 4>>& colours) {
  Scene scene;
  for (const auto& c : colours) {
    scene.textures.emplace_back(1, 1, std::vector<std::uint8_t>(c.begin(), c.end()));
  }
  return scene;
}

TextureMap texture(std::uint32_t number) { return {.texture = TextureId{number}, .place = {}}; }

constexpr float fifth = 51.0f / 255.0f;

TEST_CASE("roughness is in green and metallic in blue, times their factors", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  const Scene scene = texels({{255, 51, 102, 255}});
  const VaryingPbr varying{.factors = {.base = glm::dvec3(0.5), .metallic = 0.5, .roughness = 0.5},
                           .metallic_roughness = texture(0)};
  const Material is = material_at(scene, varying, middle(mesh), glm::vec4(1.0f));
  const Material expected = whitted({.base = glm::dvec3(0.5), .metallic = 0.2, .roughness = 0.1});
  CHECK(is.reflection.r == Approx(expected.reflection.r));
  CHECK(is.diffuse.r == Approx(expected.diffuse.r));
  CHECK(is.shininess == Approx(expected.shininess));
}

TEST_CASE("occlusion weakens the ambient term alone, by its strength", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  const Scene scene = texels({{51, 255, 255, 255}});
  VaryingPbr varying{.factors = {.metallic = 0.0}, .occlusion = texture(0)};
  const Material full = material_at(scene, varying, middle(mesh), glm::vec4(1.0f));
  CHECK(full.ambient.r == Approx(0.96f * fifth));
  CHECK(full.diffuse.r == Approx(0.96f));
  varying.occlusion_strength = 0.5;
  CHECK(material_at(scene, varying, middle(mesh), glm::vec4(1.0f)).ambient.r ==
        Approx(0.96f * 0.6f));
}

TEST_CASE("colours of textures are sRGB, and numbers are not", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  // 188 in sRGB is 0.5029 in linear light.
  const Scene scene = texels({{188, 188, 188, 188}});
  const VaryingPbr varying{.factors = {.metallic = 0.0,
                                       .roughness = 0.0,
                                       .emission = glm::dvec3(2.0),
                                       .transmission = 1.0},
                           .emission = texture(0),
                           .transmission = texture(0),
                           .specular = texture(0)};
  const Material is = material_at(scene, varying, middle(mesh), glm::vec4(1.0f));
  CHECK(is.emission.r == Approx(2.0 * 0.5029).epsilon(1e-3));
  const double number = 188.0 / 255.0;
  CHECK(is.reflection.r == Approx(0.04 * number));
  CHECK(is.transmission.r == Approx(number * (1.0 - 0.04 * number)));
}

TEST_CASE("glossiness is one less roughness, in alpha", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  const Scene scene = texels({{255, 0, 0, 51}});
  const VaryingPbr varying{.factors = {.metallic = 0.0,
                                       .roughness = 0.5,
                                       .ior = 1e6,
                                       .specular_colour = glm::dvec3(0.5)},
                           .specular_colour = texture(0),
                           .glossiness = texture(0)};
  const Material is = material_at(scene, varying, middle(mesh), glm::vec4(1.0f));
  const Material expected =
      whitted({.metallic = 0.0, .roughness = 0.9, .ior = 1e6, .specular_colour = {0.5, 0.0, 0.0}});
  CHECK(is.specular.r == Approx(expected.specular.r));
  CHECK(is.specular.g == 0.0f);
  CHECK(is.shininess == Approx(expected.shininess));
}

TEST_CASE("what a mesh has no coordinates for, its factors tell", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  const Scene scene = texels({{0, 0, 0, 0}});
  VaryingPbr varying{.factors = {.metallic = 0.0, .emission = glm::dvec3(1.0)}};
  varying.emission = {.texture = TextureId{0}, .place = {.coordinates = 3}};
  CHECK(material_at(scene, varying, middle(mesh), glm::vec4(1.0f)).emission == glm::vec3(1.0f));
}

TEST_CASE("metal mirrors in the colour of its texture", "[tracer][material]") {
  const SurfaceMesh mesh = square(1.0);
  const Scene scene;
  const VaryingPbr varying{.factors = {.roughness = 0.0}};
  const Material is = material_at(scene, varying, middle(mesh), glm::vec4(1.0f, 0.5f, 0.25f, 1.0f));
  CHECK(is.reflection == glm::vec3(1.0f, 0.5f, 0.25f));
}

TEST_CASE("a point's face is that of the nearest texel", "[tracer][material]") {
  SurfaceMesh mesh = square(1.0);
  mesh.features = std::make_shared<const FeatureMap>(
      FeatureMap{.grid = {.width = 2, .height = 2}, .faces = {4, 5, 6, 7}, .place = {}});
  const auto face = [&](double x, double y) {
    // On the triangle (-1, -1), (1, -1), (1, 1), whose second and third corner weigh these.
    return MeshPoint{.mesh = mesh, .triangle = 0, .barycentric = {(x - y) / 2, (y + 1) / 2}}.face();
  };
  CHECK(face(0.9, 0.8) == 5);  // the image's top right
  CHECK(face(0.9, -0.8) == 7);
  CHECK(face(-0.1, -0.8) == 6);
  CHECK(face(0.01, -0.8) == 7);
}

}  // namespace
}  // namespace raycat
