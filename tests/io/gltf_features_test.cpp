#include "io/gltf_features.hpp"

#include <catch2/catch.hpp>

#include "tests/io/gltf_text.hpp"

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
  CHECK(warning(two_triangles({1, 1, 1, 1, 1, 1},
                              R"("EXT_mesh_features":{"featureIds":[{"featureCount":8,)"
                              R"("texture":{"index":0}}]})")) ==
        place + "feature ids in textures are not read, and faces are found by angle");
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
  CHECK(load_scene(folder / "feat_tex/FeatureIdTexture.gltf").scene.surfaces.faces() == 1);
}

}  // namespace
}  // namespace raycat
