#include "io/gltf/material.hpp"

#include <utility>

#include <catch2/catch.hpp>

#include "tests/io/gltf/text.hpp"
#include "tracer/accel.hpp"

namespace raycat {
namespace {

const std::string ball = R"({"extras":{"shape":{"type":"sphere"},"material":0}})";

SceneFile load_material(const std::string& material) {
  return load_text("scene.gltf", gltf("0", ball, R"(,"materials":[)" + material + "]"));
}

Material material(const std::string& text) {
  const SceneFile file = load_material(text);
  CHECK(file.warnings.empty());
  return file.scene.materials.at(0);
}

// A material with these factors of pbrMetallicRoughness and more properties after them.
Material pbr(const std::string& factors, const std::string& more = "") {
  return material(R"({"pbrMetallicRoughness":{)" + factors + "}" + more + "}");
}

Material extended(const std::string& factors, const std::string& extensions) {
  return pbr(factors, R"(,"extensions":{)" + extensions + "}");
}

std::string material_error(const std::string& text) {
  return gltf_error(gltf("0", ball, R"(,"materials":[)" + text + "]"));
}

void check_colour(const glm::vec3& is, const glm::vec3& expected) {
  CHECK(is.r == Approx(expected.r).margin(1e-6));
  CHECK(is.g == Approx(expected.g).margin(1e-6));
  CHECK(is.b == Approx(expected.b).margin(1e-6));
}

const std::string plastic = R"("baseColorFactor":[0.8,0.4,0.2,1],"metallicFactor":0)";

TEST_CASE("a rough dielectric reflects four percent and scatters the rest", "[io][gltf]") {
  // ior 1.5: F0 = (0.5 / 2.5)^2 = 0.04. Roughness 1: n = 2 - 2, which is brought to 1.
  const Material is = pbr(plastic);
  check_colour(is.diffuse, {0.768f, 0.384f, 0.192f});
  check_colour(is.ambient, {0.768f, 0.384f, 0.192f});
  check_colour(is.specular, glm::vec3(0.045f));  // 0.04 * 9 / 8
  CHECK(is.shininess == 1.0f);
  CHECK(is.reflection == glm::vec3(0.0f));
  CHECK(is.transmission == glm::vec3(0.0f));
  CHECK(is.emission == glm::vec3(0.0f));
  CHECK_FALSE(is.fresnel);
  CHECK_FALSE(is.blend);
  CHECK(is.alpha_cutoff == 0.0f);
}

TEST_CASE("the highlight sharpens with the fourth power of roughness", "[io][gltf]") {
  const Material half = pbr(plastic + R"(,"roughnessFactor":0.5)");
  CHECK(half.shininess == Approx(30.0));          // 2 * 16 - 2
  check_colour(half.specular, glm::vec3(0.19f));  // 0.04 * 38 / 8
  const Material smooth = pbr(plastic + R"(,"roughnessFactor":0)");
  CHECK(smooth.shininess == 1024.0f);
  check_colour(smooth.specular, glm::vec3(1.0f));
  check_colour(smooth.reflection, glm::vec3(0.04f));
}

TEST_CASE("metals reflect in their colour and do not scatter", "[io][gltf]") {
  const Material metal = pbr(R"("baseColorFactor":[1,0.5,0.25,1],"roughnessFactor":0.15)");
  CHECK(metal.diffuse == glm::vec3(0.0f));
  check_colour(metal.reflection, {0.5f, 0.25f, 0.125f});  // half way to the last mirror, 0.3
  check_colour(metal.specular, glm::vec3(1.0f));
  // F0 = 0.5 * 0.04 + 0.5 * 0.6
  const Material half =
      pbr(R"("baseColorFactor":[0.6,0.6,0.6,1],"metallicFactor":0.5,"roughnessFactor":0)");
  check_colour(half.reflection, glm::vec3(0.32f));
  check_colour(half.diffuse, glm::vec3(0.288f));  // 0.6 * 0.5 * 0.96
}

TEST_CASE("from roughness 0.3 on nothing is mirrored", "[io][gltf]") {
  CHECK(pbr(R"("roughnessFactor":0.29)").reflection.r > 0.0f);
  CHECK(pbr(R"("roughnessFactor":0.3)").reflection == glm::vec3(0.0f));
  CHECK(pbr(R"("roughnessFactor":0.31)").reflection == glm::vec3(0.0f));
}

TEST_CASE("emission is the factor times its strength", "[io][gltf]") {
  check_colour(pbr(plastic, R"(,"emissiveFactor":[0.5,0.25,1])").emission, {0.5f, 0.25f, 1.0f});
  check_colour(pbr(plastic, R"(,"emissiveFactor":[0.5,0.25,1],"extensions":{
      "KHR_materials_emissive_strength":{"emissiveStrength":4}})")
                   .emission,
               {2.0f, 1.0f, 4.0f});
}

TEST_CASE("an unlit material is its base colour alone", "[io][gltf]") {
  const Material is =
      pbr(plastic, R"(,"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_unlit":{}})");
  check_colour(is.emission, {0.8f, 0.4f, 0.2f});
  CHECK(is.textured_emission);
  for (const glm::vec3& other :
       {is.ambient, is.diffuse, is.specular, is.reflection, is.transmission}) {
    CHECK(other == glm::vec3(0.0f));
  }
}

TEST_CASE("the index of refraction sets how much a dielectric reflects", "[io][gltf]") {
  const auto diffuse = [](const std::string& ior) {
    return extended(R"("metallicFactor":0)", R"("KHR_materials_ior":{"ior":)" + ior + "}").diffuse;
  };
  check_colour(diffuse("1"), glm::vec3(1.0f));
  check_colour(diffuse("2"), glm::vec3(8.0f / 9.0f));  // 1 - (1 / 3)^2
  CHECK(diffuse("0").r == Approx(0.0).margin(1e-5));   // which stands for infinity
}

TEST_CASE("KHR_materials_specular scales and colours what a dielectric reflects", "[io][gltf]") {
  const auto with = [](const std::string& specular) {
    return extended(plastic, R"("KHR_materials_specular":{)" + specular + "}");
  };
  const Material tinted = with(R"("specularFactor":0.5,"specularColorFactor":[1,0.5,0])");
  check_colour(tinted.specular, {0.0225f, 0.01125f, 0.0f});  // (0.02, 0.01, 0) * 9 / 8
  check_colour(tinted.diffuse, {0.784f, 0.392f, 0.196f});    // 1 - 0.02
  // 0.04 * 100 is brought to 1 before it is halved.
  const Material bright = with(R"("specularFactor":0.5,"specularColorFactor":[100,1,1])");
  check_colour(bright.diffuse, {0.4f, 0.2f, 0.1f});
}

TEST_CASE("a material without thickness transmits in a straight line", "[io][gltf]") {
  const std::string glass =
      R"("baseColorFactor":[1,0.5,1,1],"metallicFactor":0,"roughnessFactor":0)";
  const std::string all = R"("KHR_materials_transmission":{"transmissionFactor":1})";
  const Material pane = extended(glass, all);
  check_colour(pane.diffuse, glm::vec3(0.0f));
  check_colour(pane.reflection, glm::vec3(0.04f));
  check_colour(pane.transmission, {0.96f, 0.48f, 0.96f});
  CHECK(pane.thin);
  CHECK(pane.fresnel);
  check_colour(pane.grazing_reflection, glm::vec3(1.0f));
  CHECK(extended(glass, all + R"(,"KHR_materials_volume":{"thicknessFactor":0})").thin);
  const Material lens = extended(glass, all + R"(,"KHR_materials_volume":{"thicknessFactor":0.5},
                                             "KHR_materials_ior":{"ior":2})");
  CHECK_FALSE(lens.thin);
  CHECK(lens.ior == 2.0f);
  check_colour(lens.transmission, glm::vec3(1.0f, 0.5f, 1.0f) * (8.0f / 9.0f));
}

TEST_CASE("part of the light is transmitted and the rest is scattered", "[io][gltf]") {
  const auto with = [](const std::string& factors) {
    return extended(factors, R"("KHR_materials_transmission":{"transmissionFactor":0.25})");
  };
  const Material is = with(R"("metallicFactor":0.5,"roughnessFactor":0.15)");
  // F0 = 0.52: k_t = 0.25 * 0.5 * 0.48, k_s = 0.52 / 2, O_d = 0.5 * 0.75 * 0.96.
  check_colour(is.transmission, glm::vec3(0.06f));
  check_colour(is.reflection, glm::vec3(0.26f));
  check_colour(is.diffuse, glm::vec3(0.36f));
  check_colour(is.grazing_reflection, glm::vec3(0.5f));
  // Too rough to mirror anything, at any angle.
  const Material frosted = with(R"("metallicFactor":0,"roughnessFactor":0.5)");
  CHECK_FALSE(frosted.fresnel);
  check_colour(frosted.transmission, glm::vec3(0.24f));
}

TEST_CASE("BLEND lets through what the factors leave uncovered", "[io][gltf]") {
  const Material quarter =
      pbr(R"("baseColorFactor":[1,1,1,0.25],"metallicFactor":0)", R"(,"alphaMode":"BLEND")");
  CHECK(quarter.blend);
  CHECK(quarter.thin);
  CHECK(quarter.alpha == 0.25f);
  check_colour(quarter.transmission, glm::vec3(0.75f));
  CHECK_FALSE(quarter.fresnel);
  const Material whole = pbr(plastic, R"(,"alphaMode":"BLEND")");
  CHECK(whole.transmission == glm::vec3(0.0f));
}

TEST_CASE("MASK keeps its cutoff, which is a half unless given", "[io][gltf]") {
  const Material is =
      pbr(R"("baseColorFactor":[1,1,1,0.75])", R"(,"alphaMode":"MASK","alphaCutoff":0.25)");
  CHECK(is.alpha == 0.75f);
  CHECK(is.alpha_cutoff == 0.25f);
  CHECK_FALSE(is.blend);
  CHECK(is.transmission == glm::vec3(0.0f));
  CHECK(material(R"({"alphaMode":"MASK"})").alpha_cutoff == 0.5f);
  CHECK(pbr(R"("baseColorFactor":[1,1,1,0.75])").alpha == 1.0f);
  CHECK(material_error(R"({"alphaMode":"GLOW"})") ==
        "materials[0]: alphaMode: unknown mode 'GLOW'; expected OPAQUE, MASK or BLEND");
}

TEST_CASE("opaque materials are single-sided unless they are said to be double-sided",
          "[io][gltf]") {
  CHECK(pbr(plastic).single_sided);
  CHECK(material(R"({"alphaMode":"MASK"})").single_sided);
  CHECK(material(R"({"extras":{"whitted":{"diffuse":[1,1,1]}}})").single_sided);
  CHECK_FALSE(pbr(plastic, R"(,"doubleSided":true)").single_sided);
  // What lets light through shows its back faces.
  CHECK_FALSE(material(R"({"alphaMode":"BLEND"})").single_sided);
  CHECK_FALSE(
      extended(plastic, R"("KHR_materials_transmission":{"transmissionFactor":1})").single_sided);
  CHECK_FALSE(material(R"({"extras":{"whitted":{"transmission":0.5}}})").single_sided);
}

// A triangle in the plane z = 0 whose front is at +z, or where its node mirrors it, seen from +z
// and -z.
std::pair<bool, bool> seen_from(const std::string& node, const std::string& material,
                                BackFaces back_faces = BackFaces::hide) {
  const TemporaryFile file(
      "scene.gltf",
      gltf("0", R"({"mesh":0)" + node + "}",
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0})" + material + R"(}]}],
           "materials":[{},{"doubleSided":true}],
           "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                         "min":[-1,-1,0],"max":[1,1,0]}],
           "bufferViews":[{"buffer":0,"byteLength":36}],)" +
               buffer_of(floats({-1, -1, 0, 1, -1, 0, 0, 1, 0}))));
  LoadOptions options;
  options.back_faces = back_faces;
  const SceneFile loaded = load_scene(file.path(), options);
  const Accel accel(loaded.scene);
  Solid::Scratch scratch;
  return {accel.closest({.origin = {0, 0, 5}, .direction = {0, 0, -1}}, scratch).has_value(),
          accel.closest({.origin = {0, 0, -5}, .direction = {0, 0, 1}}, scratch).has_value()};
}

TEST_CASE("which side of a mesh is seen is decided by its winding and its node's determinant",
          "[io][gltf]") {
  const std::string material = GENERATE("", R"(,"material":0)");
  CHECK(seen_from("", material) == std::pair(true, false));
  CHECK(seen_from(R"(,"rotation":[0,1,0,0])", material) == std::pair(false, true));
  // Mirrored along x a triangle stays where it is and winds the other way, which then is the
  // front; along z, front and back change places.
  CHECK(seen_from(R"(,"scale":[-1,1,1])", material) == std::pair(true, false));
  CHECK(seen_from(R"(,"scale":[1,1,-1])", material) == std::pair(false, true));
  CHECK(seen_from("", material, BackFaces::show) == std::pair(true, true));
  CHECK(seen_from("", R"(,"material":1)") == std::pair(true, true));
}

TEST_CASE("specular-glossiness gives F0 outright", "[io][gltf]") {
  const Material is = material(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
      "diffuseFactor":[0.5,0.5,0.5,1],"specularFactor":[0.2,0.1,0],"glossinessFactor":1}}})");
  check_colour(is.reflection, {0.2f, 0.1f, 0.0f});
  check_colour(is.diffuse, glm::vec3(0.4f));
}

TEST_CASE("factors out of range are brought into it with a warning", "[io][gltf]") {
  const auto file = load_material(
      R"({"name":"paint","pbrMetallicRoughness":{"metallicFactor":2,"roughnessFactor":0}})");
  check_colour(file.scene.materials[0].reflection, glm::vec3(1.0f));
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] ==
        "materials[0] 'paint': metallicFactor must be from 0 to 1, but is 2; 1 is used");
}

TEST_CASE("what has no material is rough and white", "[io][gltf]") {
  const auto file = load_text("scene.gltf", gltf("0", R"({"extras":{"shape":{"type":"box"}}})"));
  REQUIRE(file.scene.materials.size() == 1);
  CHECK(file.scene.materials[0].name == "default");
  check_colour(file.scene.materials[0].diffuse, glm::vec3(0.768f));
  CHECK(file.scene.materials[0].reflection == glm::vec3(0.0f));
}

TEST_CASE("whitted extras replace the table, each constant that is left out being zero",
          "[io][gltf]") {
  const Material is = pbr(plastic, R"(,"alphaMode":"BLEND","emissiveFactor":[1,1,1],
      "extras":{"whitted":{"specular":[0.5,0.25,0],"transmission":0.25}})");
  check_colour(is.specular, {0.5f, 0.25f, 0.0f});
  check_colour(is.transmission, glm::vec3(0.25f));
  CHECK(is.emission == glm::vec3(0.0f));
  CHECK(is.diffuse == glm::vec3(0.0f));
  CHECK(is.shininess == 1.0f);
  CHECK(is.ior == 1.0f);
  CHECK_FALSE(is.blend);
  CHECK_FALSE(is.thin);
  CHECK(material_error(R"({"extras":{"whitted":{"diffuse":[0,-1,0]}}})") ==
        "materials[0]: extras.whitted: diffuse must be from 0 to 1000000, but is -1");
  CHECK(material_error(R"({"extras":{"whitted":{"reflection":[1,2]}}})") ==
        "materials[0]: extras.whitted: reflection: expected 3 numbers, but found [1,2]");
}

TEST_CASE("a volume absorbs what its colour lacks at its distance (Beer's law)", "[io][gltf]") {
  const auto with = [](const std::string& volume) {
    return extended("", R"("KHR_materials_transmission":{"transmissionFactor":1},
                           "KHR_materials_volume":{)" +
                            volume + "}")
        .absorption;
  };
  // exp(-absorption * 2) is the colour.
  check_colour(with(R"("thicknessFactor":1,"attenuationDistance":2,
                       "attenuationColor":[1,0.5,0.13533528323661270])"),
               {0.0f, 0.34657359f, 1.0f});
  CHECK(with(R"("thicknessFactor":1,"attenuationColor":[1,0.5,0])") == glm::vec3(0.0f));
  CHECK(with(R"("attenuationDistance":2,"attenuationColor":[1,0.5,0])") == glm::vec3(0.0f));
  CHECK(with(R"("thicknessFactor":1,"attenuationDistance":1,"attenuationColor":[0,0,0])").r >
        60.0f);
}

}  // namespace
}  // namespace raycat
