#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "io/gltf/material.hpp"
#include "tests/io/gltf/text.hpp"
#include "tests/io/images/png_file.hpp"

namespace raycat {
namespace {

// A textured triangle at (0, 0), (1, 0), (0, 1) in space and on the image, whose colours are 1.
std::string textured(const std::string& image, const std::string& info = "",
                     const std::string& material = "", const std::string& attributes = "") {
  const std::string positions = floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string coordinates = floats({0, 0, 1, 0, 0, 1});
  const std::string colours = floats({1, 1, 1, 1, 1, 1, 1, 1, 1});
  return gltf("0", R"({"mesh":0})",
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1)" +
                  attributes +
                  R"(},"material":0}]}],"accessors":[
          {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
          {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},
          {"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}],
          "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},
          {"buffer":0,"byteOffset":60,"byteLength":36}],
          "materials":[{"pbrMetallicRoughness":{"metallicFactor":0)" +
                  (image.empty() ? "" : R"(,"baseColorTexture":{"index":0)" + info + "}") + "}" +
                  material + R"(}],"textures":[{"source":0}],"images":[{"uri":")" + image +
                  R"("}],)" + buffer_of(positions + coordinates + colours));
}

// Where the triangle's corners are on its base texture.
std::vector<glm::dvec2> places(const SceneFile& file) {
  const MeshInstance& instance = file.scene.meshes.at(0);
  const Material& material = file.scene.materials.at(static_cast<std::size_t>(instance.material));
  std::vector<glm::dvec2> places;
  for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
    const MeshPoint point{.mesh = *instance.mesh, .triangle = 0, .barycentric = corner};
    places.push_back(point.on(material.base_texture.value().place).value());
  }
  return places;
}

std::string white() { return data_uri(png(Image(1, 1, glm::vec3(1.0f)))); }

TEST_CASE("a base colour texture is decoded and looked up at TEXCOORD_0", "[io][gltf]") {
  const auto file = load_text("scene.gltf", textured(white()));
  CHECK(file.warnings.empty());
  REQUIRE(file.scene.textures.size() == 1);
  REQUIRE(file.scene.materials[0].base_texture);
  CHECK(file.scene.materials[0].base_texture->texture == TextureId{0});
  CHECK(file.scene.textures[0].sample({0.5, 0.5}) == glm::vec4(1.0f));
  CHECK(places(file) == std::vector<glm::dvec2>{{0, 0}, {1, 0}, {0, 1}});
}

// The extension's own example, which shows the lower left quadrant: its formula in GLSL turns the
// other way and would leave the image.
TEST_CASE("KHR_texture_transform turns coordinates against the clock", "[io][gltf]") {
  const auto file =
      load_text("scene.gltf", textured(white(), R"(,"extensions":{"KHR_texture_transform":{
      "offset":[0,1],"rotation":1.5707963267948966,"scale":[0.5,0.5]}})"));
  const auto at = places(file);
  CHECK(glm::distance(at[0], glm::dvec2(0.0, 1.0)) < 1e-6);
  CHECK(glm::distance(at[1], glm::dvec2(0.0, 0.5)) < 1e-6);
  CHECK(glm::distance(at[2], glm::dvec2(0.5, 1.0)) < 1e-6);
}

TEST_CASE("KHR_texture_transform may name other coordinates", "[io][gltf]") {
  const auto file = load_text(
      "scene.gltf", textured(white(), R"(,"texCoord":7,"extensions":{"KHR_texture_transform":{
      "scale":[2,3],"texCoord":0}})"));
  CHECK(places(file) == std::vector<glm::dvec2>{{0, 0}, {2, 0}, {0, 3}});
}

TEST_CASE("a missing or broken image is a warning and its material stays white", "[io][gltf]") {
  const auto [image, warning] = GENERATE(table<std::string, std::string>(
      {{"none.png", "images[0]: no such file; it is left out"},
       {"../a.png", "images[0]: URI '../a.png' leads out of the file's folder; it is left out"},
       {"data:,GIF89a", "images[0]: neither PNG, JPEG nor WebP; it is left out"}}));
  const auto file = load_text("scene.gltf", textured(image));
  CHECK(file.warnings == std::vector{warning});
  CHECK(file.scene.textures.empty());
  CHECK_FALSE(file.scene.materials[0].base_texture);
  CHECK(file.scene.materials[0].diffuse == glm::vec3(0.96f));
}

TEST_CASE("an image of more pixels than allowed is a warning", "[io][gltf]") {
  const auto file =
      load_text("scene.gltf", textured(data_uri(claimed(png(Image(1, 1)), 8193, 8192))));
  CHECK(file.warnings == std::vector<std::string>{
                             "images[0]: 8193 x 8192 pixels are more than the 67108864 allowed; "
                             "it is left out"});
}

TEST_CASE("BLEND lets all through where a texture or the vertices may have holes", "[io][gltf]") {
  const auto transmission = [](const std::string& image, const std::string& attributes) {
    return load_text("scene.gltf", textured(image, "", R"(,"alphaMode":"BLEND")", attributes))
        .scene.materials[0]
        .transmission;
  };
  CHECK(transmission("", "") == glm::vec3(0.0f));
  CHECK(transmission("", R"(,"COLOR_0":2)") == glm::vec3(1.0f));
  CHECK(transmission(white(), "") == glm::vec3(1.0f));
}

TEST_CASE("textures of all PBR parameters are read, each with its coordinates", "[io][gltf]") {
  const std::string map = R"({"index":0,"texCoord":0})";
  const std::string other = R"({"index":0,"texCoord":1})";
  const auto file = load_text(
      "scene.gltf",
      textured(white(), "",
               R"(,"occlusionTexture":{"index":0,"texCoord":1,"strength":0.5},"emissiveTexture":)" +
                   map + R"(,"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_specular":{)" +
                   R"("specularTexture":)" + map + R"(,"specularColorTexture":)" + other +
                   R"(},"KHR_materials_transmission":{"transmissionFactor":1,)" +
                   R"("transmissionTexture":)" + map + "}}",
               R"(,"TEXCOORD_1":1)"));
  CHECK(file.warnings.empty());
  CHECK(file.scene.textures.size() == 1);
  const Material& material = file.scene.materials[0];
  REQUIRE(material.varying);
  CHECK(material.varying->occlusion_strength == 0.5);
  CHECK(material.varying->occlusion.value().place.coordinates == 1);
  CHECK(material.varying->emission.value().place.coordinates == 0);
  CHECK(material.varying->specular.has_value());
  CHECK(material.varying->specular_colour.value().place.coordinates == 1);
  CHECK(material.varying->transmission.has_value());
  CHECK_FALSE(material.varying->metallic_roughness.has_value());
  CHECK(file.scene.meshes[0].mesh->texture_coordinates.size() == 2);
}

TEST_CASE("a rough dielectric with a base texture alone varies in no other way", "[io][gltf]") {
  CHECK_FALSE(load_text("scene.gltf", textured(white())).scene.materials[0].varying);
}

TEST_CASE("an image of another format takes the place of a missing one", "[io][gltf]") {
  // A document whose texture has no `source` but an extension's.
  std::string text = textured(white());
  const std::string source = R"("textures":[{"source":0}])";
  text.replace(text.find(source), source.size(),
               R"("textures":[{"extensions":{"EXT_texture_webp":{"source":0}}}])");
  const auto file = load_text("scene.gltf", text);
  CHECK(file.warnings.empty());
  CHECK(file.scene.textures.size() == 1);
}

}  // namespace
}  // namespace raycat
