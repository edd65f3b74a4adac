#include "io/gltf/features.hpp"

#include <array>

#include <catch2/catch.hpp>

#include "io/load_scene.hpp"
#include "tests/io/gltf/text.hpp"
#include "tests/io/images/png_file.hpp"
#include "tracer/scene_crossings.hpp"
#include "tracer/srgb.hpp"

namespace raycat {
namespace {

constexpr const char* positions =
    R"({"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"})";
constexpr const char* ids = R"(,{"bufferView":1,"componentType":5126,"count":6,"type":"SCALAR"})";

// Two triangles in one plane, whose vertices have these ids, in a mesh with more members.
std::string two_triangles(std::initializer_list<float> of_vertex, const std::string& extension,
                          const std::string& more = "") {
  const std::string points = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  return gltf("0", R"({"name":"pair","mesh":0})",
              std::string(R"(,"extensionsUsed":["EXT_mesh_features"],"meshes":[{"primitives":[{)") +
                  R"("attributes":{"POSITION":0,"_FEATURE_ID_0":1},"extensions":{)" + extension +
                  "}}]" + more + R"(}],"accessors":[)" + positions + ids +
                  R"(],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":72},)" +
                  R"({"buffer":0,"byteOffset":72,"byteLength":24}],)" +
                  buffer_of(points + floats(of_vertex)));
}

std::vector<std::uint32_t> faces(const SceneFile& file) {
  return file.scene.meshes.at(0).mesh->triangles.faces;
}

constexpr const char* plain =
    R"("EXT_mesh_features":{"featureIds":[{"featureCount":8,"attribute":0}]})";

TEST_CASE("feature ids of an attribute are the faces", "[io][gltf][features]") {
  const SceneFile file = load_text("scene.gltf", two_triangles({5, 5, 5, 2, 2, 2}, plain));
  CHECK(file.warnings.empty());
  CHECK(faces(file) == std::vector<std::uint32_t>{5, 2});
  CHECK(file.scene.surfaces.faces() == 6);
}

TEST_CASE("without attribute or texture a vertex is its own feature", "[io][gltf][features]") {
  const SceneFile file = load_text(
      "scene.gltf", two_triangles({0, 0, 0, 0, 0, 0},
                                  R"("EXT_mesh_features":{"featureIds":[{"featureCount":6}]})"));
  CHECK(faces(file) == std::vector<std::uint32_t>{0, 3});
}

TEST_CASE("what has no feature is a face of its own", "[io][gltf][features]") {
  const SceneFile file = load_text(
      "scene.gltf",
      two_triangles({9, 9, 9, 1, 1, 1}, R"("EXT_mesh_features":{"featureIds":[)"
                                        R"({"featureCount":2,"nullFeatureId":9,"attribute":0}]})"));
  CHECK(faces(file) == std::vector<std::uint32_t>{2, 1});
}

TEST_CASE("huge feature ids are numbered by their order", "[io][gltf][features]") {
  const SceneFile file = load_text(
      "scene.gltf",
      two_triangles(
          {4e6f, 4e6f, 4e6f, 3e6f, 3e6f, 3e6f},
          R"("EXT_mesh_features":{"featureIds":[{"featureCount":5000000,"attribute":0}]})"));
  CHECK(faces(file) == std::vector<std::uint32_t>{1, 0});
  CHECK(file.scene.surfaces.faces() < 10);
}

TEST_CASE("feature ids that cannot be read are ignored with a warning", "[io][gltf][features]") {
  const auto warning = [](const std::string& text) {
    const SceneFile file = load_text("scene.gltf", text);
    CHECK(faces(file) == std::vector<std::uint32_t>{0, 0});  // by angle
    REQUIRE(file.warnings.size() == 1);
    return file.warnings.front();
  };
  const std::string place = "meshes[0]: primitives[0]: EXT_mesh_features: ";
  CHECK(warning(two_triangles({1, 1, 1, 8, 8, 8}, plain)) ==
        place + "vertex 3 has feature 8, which is none of 8, and all are ignored");
  CHECK(warning(two_triangles({-1, 1, 1, 1, 1, 1}, plain)) ==
        place + "vertex 0 has feature -1, which is none of 8, and all are ignored");
  CHECK(warning(two_triangles({1, 1, 1, 1, 1, 1},
                              R"("EXT_mesh_features":{"featureIds":[{"featureCount":8,)"
                              R"("attribute":3}]})")) ==
        place + "has no attribute with an id for each vertex and is ignored");
  for (const char* const bad : {R"("EXT_mesh_features":{})", R"("EXT_mesh_features":7)",
                                R"("EXT_mesh_features":{"featureIds":{}})"}) {
    CHECK(warning(two_triangles({1, 1, 1, 1, 1, 1}, bad)) == place + "has no feature ids");
  }
}

TEST_CASE("a table of names says what features are of", "[io][gltf][features]") {
  const SceneFile file =
      load_text("scene.gltf", two_triangles({1, 1, 1, 0, 0, 0}, plain,
                                            R"(,"extras":{"raycat":{"object":"pair","primitives":[)"
                                            R"({"name":"a","faces":2},{"name":"b","faces":3}],)"
                                            R"("features":[[1,2],[0,1]]}})"));
  const SurfaceTable& surfaces = file.scene.surfaces;
  CHECK(file.warnings.empty());
  CHECK(surfaces.primitives() == 2);
  CHECK(surfaces.faces() == 5);
  CHECK(faces(file) == std::vector<std::uint32_t>{1, 4});
  CHECK(surfaces.name(surfaces.primitive(SurfaceId{4})) == "b");
  CHECK(surfaces.face_in_primitive(SurfaceId{4}) == 2);
}

TEST_CASE("a table of names that does not fit is refused", "[io][gltf][features]") {
  const auto error = [](const std::string& table, std::initializer_list<float> of_vertex) {
    return gltf_error(two_triangles(of_vertex, plain, R"(,"extras":{"raycat":)" + table + "}"));
  };
  const std::initializer_list<float> ones{1, 1, 1, 0, 0, 0};
  CHECK(error("{}", ones) == "meshes[0]: extras.raycat: primitives: expected an array");
  CHECK(error(R"({"primitives":[{"name":"a","faces":2}]})", ones) ==
        "meshes[0]: extras.raycat: features: expected an array");
  CHECK(error(R"({"primitives":[{"name":"a","faces":-2}],"features":[]})", ones) ==
        "meshes[0]: extras.raycat: primitives: each needs a name and a number of faces");
  CHECK(error(R"({"primitives":[{"name":"a","faces":2}],"features":[[0,2]]})", ones) ==
        "meshes[0]: extras.raycat: features: number 0 is not of a face of a primitive");
  CHECK(error(R"({"primitives":[{"name":"a","faces":2}],"features":[[0,1]]})", ones) ==
        "meshes[0]: primitives[0]: extras.raycat: features: feature 1 is not among the 1");
  CHECK(error(R"({"primitives":[{"name":"a","faces":134217727},{"name":"b","faces":134217727}],)"
              R"("features":[]})",
              ones) == "meshes[0]: extras.raycat: primitives: at most 134217728 faces are read");
  CHECK(error(R"({"primitives":[{"name":"a","faces":2}],"features":[[0,0],[0,1]]})",
              {9, 9, 9, 0, 0, 0}) ==
        "meshes[0]: primitives[0]: extras.raycat: names features, but none can be read");
}

TEST_CASE("real assets with features have them as faces", "[io][gltf][features]") {
  const auto folder = corpus() / "gltf";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  for (const char* const name : {"feat_attr/FeatureIdAttribute.gltf",
                                 "feat_attr_table/FeatureIdAttributeAndPropertyTable.gltf",
                                 "feat_multi/MultipleFeatureIdsAndProperties.gltf",
                                 "feat_default_implicit/ValidFeatureIdAttributeDefault.gltf"}) {
    INFO(name);
    const SceneFile file = load_scene(folder / name);
    // Each of four squares is two triangles of one feature.
    CHECK(faces(file) == std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 3, 3});
    CHECK(file.scene.surfaces.faces() == 4);
  }
  // Four quarters of one image.
  CHECK(load_scene(folder / "feat_tex/FeatureIdTexture.gltf").scene.surfaces.faces() == 4);
}

// A square from (0, 0) to (1, 1) on an image of 2 x 1 texels with these values in red and green,
// whose faces are told by `set`.
std::string textured_square(std::array<std::array<int, 2>, 2> texels, const std::string& set,
                            const std::string& image = "") {
  Image pixels(2, 1);
  for (int i = 0; i < 2; ++i) {
    const auto& [red, green] = texels[static_cast<std::size_t>(i)];
    pixels.pixels[static_cast<std::size_t>(i)] = {
        linear_from_srgb(static_cast<float>(red) / 255.0f),
        linear_from_srgb(static_cast<float>(green) / 255.0f), 0.0f};
  }
  const std::string points = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  const std::string places = floats({0, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0});
  return gltf(
      "0", R"({"mesh":0})",
      R"(,"extensionsUsed":["EXT_mesh_features"],"meshes":[{"primitives":[{"attributes":)"
      R"({"POSITION":0,"TEXCOORD_1":1},"extensions":{"EXT_mesh_features":{"featureIds":[)" +
          set +
          R"(]}}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},
          {"bufferView":1,"componentType":5126,"count":6,"type":"VEC2"}],
          "bufferViews":[{"buffer":0,"byteLength":72},
          {"buffer":0,"byteOffset":72,"byteLength":48}],
          "textures":[{"source":0}],"images":[{"uri":")" +
          (image.empty() ? data_uri(png(pixels)) : image) + R"("}],)" + buffer_of(points + places));
}

std::uint32_t face_at(const SceneFile& file, double x, double y) {
  const SceneCrossings crossings(file.scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> found;
  crossings.cross({.origin = {x, y, 1}, .direction = {0, 0, -1}}, scratch, found);
  return static_cast<std::uint32_t>(found.at(0).surface);
}

TEST_CASE("feature ids of a texture are the faces of its texels", "[io][gltf][features]") {
  const SceneFile file =
      load_text("scene.gltf", textured_square({{{3, 0}, {1, 0}}}, R"({"featureCount":4,"texture":)"
                                                                  R"({"index":0,"texCoord":1}})"));
  CHECK(file.warnings.empty());
  CHECK(file.scene.surfaces.faces() == 4);
  for (const double y : {0.1, 0.45, 0.9}) {  // on both triangles
    CHECK(face_at(file, 0.2, y) == 3);
    CHECK(face_at(file, 0.49, y) == 3);
    CHECK(face_at(file, 0.51, y) == 1);
  }
}

TEST_CASE("channels of a texel are the bytes of an id", "[io][gltf][features]") {
  // 1 + 256 * 2 and 1 + 256 * 1, which are the largest and the smallest that there are.
  const SceneFile file = load_text(
      "scene.gltf",
      textured_square(
          {{{1, 2}, {1, 1}}},
          R"({"featureCount":1000,"texture":{"index":0,"texCoord":1,"channels":[0,1]}})"));
  CHECK(face_at(file, 0.2, 0.2) == 513);
  CHECK(face_at(file, 0.8, 0.2) == 257);
}

TEST_CASE("texels without a feature are a face of their own", "[io][gltf][features]") {
  const SceneFile null =
      load_text("scene.gltf",
                textured_square(
                    {{{9, 0}, {1, 0}}},
                    R"({"featureCount":2,"nullFeatureId":9,"texture":{"index":0,"texCoord":1}})"));
  CHECK(null.warnings.empty());
  CHECK(face_at(null, 0.2, 0.2) == 2);
  const SceneFile strange =
      load_text("scene.gltf", textured_square({{{9, 0}, {1, 0}}}, R"({"featureCount":2,"texture":)"
                                                                  R"({"index":0,"texCoord":1}})"));
  CHECK(strange.warnings ==
        std::vector<std::string>{"meshes[0]: primitives[0]: EXT_mesh_features: 1 texels have a "
                                 "feature that is none of 2; they count as having none"});
  CHECK(face_at(strange, 0.2, 0.2) == 2);
}

TEST_CASE("a feature texture that cannot be looked up leaves faces to angles",
          "[io][gltf][features]") {
  const auto warnings = [](const std::string& set, const std::string& image = "") {
    const SceneFile file = load_text("scene.gltf", textured_square({{{3, 0}, {1, 0}}}, set, image));
    CHECK(file.scene.surfaces.faces() == 1);
    return file.warnings;
  };
  const std::string place = "meshes[0]: primitives[0]: EXT_mesh_features: ";
  CHECK(warnings(R"({"texture":{"index":0,"texCoord":0}})") ==
        std::vector{place + "its texture coordinates are missing, and faces are found by angle"});
  CHECK(warnings(R"({"texture":{"index":0,"texCoord":1,"channels":[7]}})") ==
        std::vector{place + "texture: has no channels from 0 to 3, and faces are found by angle"});
  CHECK(warnings(R"({"texture":{"index":0,"texCoord":1}})", "none.png").back() ==
        place + "its image cannot be read, and faces are found by angle");
  CHECK(gltf_error(textured_square({}, R"({"texture":{"index":7}})")) ==
        "meshes[0]: primitives[0]: EXT_mesh_features: texture: index: there is no textures[7]; the "
        "file has 1");
}

}  // namespace
}  // namespace raycat
