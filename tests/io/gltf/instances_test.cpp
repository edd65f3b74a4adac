#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

// A triangle placed three times by EXT_mesh_gpu_instancing, at a node moved by (0, 10, 0).
std::string instanced(const std::string& attributes, const std::string& extensions = "") {
  const std::string data = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}) +  // 0: positions
                           floats({0, 0, 0, 5, 0, 0, 9, 0, 0}) +  // 36: translations
                           floats({1, 1, 1, 2, 2, 2, 3, 1, 1}) +  // 72: scales
                           floats({7, 4, 7});                     // 108: features
  return gltf("0",
              fmt::format(R"({{"name":"part","mesh":0,"translation":[0,10,0],"extensions":
{{"EXT_mesh_gpu_instancing":{{"attributes":{{{}}}}}{}}}}})",
                          attributes, extensions),
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":72,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":0,"byteOffset":108,"componentType":5126,"count":3,"type":"SCALAR"},
{"bufferView":0,"byteOffset":108,"componentType":5126,"count":2,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":120}],"extensionsRequired":["EXT_mesh_gpu_instancing"],)" +
                  buffer_of(data));
}

const std::string places = R"("TRANSLATION":1,"SCALE":2)";

TEST_CASE("each instance is an object that shares its mesh", "[io][gltf][instances]") {
  const SceneFile file = load_text("scene.gltf", instanced(places));
  const Scene& scene = file.scene;
  REQUIRE(scene.meshes.size() == 3);
  CHECK(scene.surfaces.objects() == 3);
  CHECK(scene.surfaces.name(ObjectId{2}) == "part[2]");
  CHECK(scene.meshes[0].mesh == scene.meshes[2].mesh);
  CHECK(scene.meshes[1].transform.point({1, 0, 0}) == glm::dvec3(7, 10, 0));
  CHECK(scene.meshes[2].transform.point({1, 0, 0}) == glm::dvec3(12, 10, 0));
  CHECK(file.triangles == 3);
}

TEST_CASE("instances of one feature are one object", "[io][gltf][instances]") {
  const auto with = [](const std::string& set) {
    return load_text("scene.gltf",
                     instanced(places + R"(,"_FEATURE_ID_0":3)",
                               R"(,"EXT_instance_features":{"featureIds":[{)" + set + "}]}"));
  };
  const SceneFile by_attribute = with(R"("featureCount":2,"attribute":0)");
  CHECK(by_attribute.scene.surfaces.objects() == 2);
  CHECK(by_attribute.scene.surfaces.primitives() == 3);
  CHECK(by_attribute.scene.surfaces.name(ObjectId{0}) == "part[7]");
  CHECK(by_attribute.scene.surfaces.name(ObjectId{1}) == "part[4]");
  CHECK(by_attribute.scene.meshes[1].transform.point({0, 0, 0}) == glm::dvec3(9, 10, 0));
  CHECK(by_attribute.warnings.empty());
  CHECK(with(R"("featureCount":3)").scene.surfaces.objects() == 3);
  CHECK(with(R"("featureCount":1,"attribute":0,"nullFeatureId":7)").scene.surfaces.objects() == 3);
  CHECK(with(R"("featureCount":1,"attribute":5)").warnings ==
        std::vector<std::string>{"node 0 'part': EXT_instance_features: there is no attribute "
                                 "_FEATURE_ID_5; each instance is an object"});
}

TEST_CASE("instances that do not fit together are refused", "[io][gltf][instances]") {
  CHECK(gltf_error(instanced(R"("TRANSLATION":1,"_ID":4)"))
            .find("EXT_mesh_gpu_instancing: attributes: _ID has 2 elements where another has 3") !=
        std::string::npos);
  CHECK(gltf_error(instanced(R"("TRANSLATION":3)")) ==
        "node 0 'part': EXT_mesh_gpu_instancing: TRANSLATION: accessors[3] has 1 components");
  CHECK(gltf_error(instanced(R"("TRANSLATION":8)")) ==
        "node 0 'part': EXT_mesh_gpu_instancing: TRANSLATION: there is no accessors[8]; the file "
        "has 5");
}

TEST_CASE("what KHR_node_visibility hides is not there, with all below it",
          "[io][gltf][instances]") {
  const std::string hidden = R"("extensions":{"KHR_node_visibility":{"visible":false}})";
  const std::string ball = R"("extras":{"shape":{"type":"sphere"}})";
  const SceneFile file = load_text(
      "scene.gltf",
      gltf("0,1,3", "{" + hidden + "," + ball + R"(},{)" + hidden + R"(,"children":[2]},{)" + ball +
                        R"(},{"extras":{"csg":"union"},"children":[4,5]},{)" + ball + R"(},{)" +
                        hidden + "," + ball + "}"));
  CHECK(file.scene.surfaces.objects() == 1);
  CHECK(file.scene.surfaces.primitives() == 1);
}

}  // namespace
}  // namespace raycat
