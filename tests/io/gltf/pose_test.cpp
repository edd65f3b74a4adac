#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "io/load_scene.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

SceneFile load_posed(const std::string& document, const LoadOptions& options) {
  const TemporaryFile file("scene.gltf", document);
  return load_scene(file.path(), options);
}

// One triangle at node 0, and an animation of node 0 by `channel` with the key frames of `data`:
// first the triangle's corners, then times (accessor 1), then values (accessor 2).
std::string animated(const std::string& path, const std::string& interpolation,
                     const std::string& times, const std::string& values, int count,
                     const std::string& type, const std::string& more = "") {
  const std::string data = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}) + times + values;
  const std::string value_type = type;
  const std::size_t width = type == "SCALAR" ? 4 : type == "VEC3" ? 12 : 16;
  return gltf(
      "0", R"({"mesh":0})",
      fmt::format(
          R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}{9}}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},
{{"bufferView":0,"byteOffset":36,"componentType":5126,"count":{0},"type":"SCALAR"}},
{{"bufferView":0,"byteOffset":{1},"componentType":5126,"count":{2},"type":"{3}"}}],
"bufferViews":[{{"buffer":0,"byteLength":{4}}}],{5},
"animations":[{{"name":"move","channels":[{{"sampler":0,"target":{{"node":0,"path":"{6}"}}}}],
"samplers":[{{"input":1,"output":2{7}}}]}}{8}])",
          count, 36 + times.size(), values.size() / width, value_type, data.size(), buffer_of(data),
          path, interpolation.empty() ? "" : fmt::format(R"(,"interpolation":"{}")", interpolation),
          "", more));
}

glm::dvec3 corner(const SceneFile& file, std::size_t number) {
  const MeshInstance& instance = file.scene.meshes.at(0);
  return instance.transform.point(instance.mesh->triangles.positions.at(number));
}

TEST_CASE("an animation moves a node between its key frames", "[io][gltf][pose]") {
  const std::string times = floats({1, 3});
  const std::string values = floats({0, 0, 0, 4, 0, 0});
  const auto x_at = [&](const std::string& interpolation, double time) {
    return corner(load_posed(animated("translation", interpolation, times, values, 2, "VEC3"),
                             {.time = time}),
                  0)
        .x;
  };
  CHECK(x_at("", 0.0) == 0.0);
  CHECK(x_at("LINEAR", 1.5) == 1.0);
  CHECK(x_at("", 2.0) == 2.0);
  CHECK(x_at("", 99.0) == 4.0);
  CHECK(x_at("STEP", 2.999) == 0.0);
  CHECK(x_at("STEP", 3.0) == 4.0);
  CHECK(corner(load_posed(animated("translation", "", times, values, 2, "VEC3"), {}), 0).x == 0.0);
}

TEST_CASE("a rotation goes along the sphere", "[io][gltf][pose]") {
  // From none to a quarter turn about z; half way is an eighth.
  const float s = static_cast<float>(std::sqrt(0.5));
  const SceneFile file = load_posed(
      animated("rotation", "LINEAR", floats({0, 1}), floats({0, 0, 0, 1, 0, 0, s, s}), 2, "VEC4"),
      {.time = 0.5});
  CHECK(glm::distance(corner(file, 1), glm::dvec3(std::sqrt(0.5), std::sqrt(0.5), 0)) < 1e-6);
}

TEST_CASE("a cubic spline has glTF's Hermite form", "[io][gltf][pose]") {
  // Values 0 and 1 over two seconds, leaving with slope 1 and arriving with slope 0. At a quarter:
  // p = (2t^3 - 3t^2 + 1) 0 + 2 (t^3 - 2t^2 + t) 1 + (3t^2 - 2t^3) 1 = 0.28125 + 0.15625.
  const SceneFile file = load_posed(
      animated("translation", "CUBICSPLINE", floats({0, 2}),
               floats({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 9, 9, 9}), 2, "VEC3"),
      {.time = 0.5});
  CHECK(corner(file, 0).x == 0.4375);
}

TEST_CASE("morph targets are added by the weights of node, mesh or animation", "[io][gltf][pose]") {
  const std::string targets = R"(,"targets":[{"POSITION":0}])";  // its own corners: twice as large
  const std::string document =
      animated("weights", "LINEAR", floats({0, 1}), floats({0, 1}), 2, "SCALAR", targets);
  CHECK(corner(load_posed(document, {}), 1) == glm::dvec3(1, 0, 0));
  CHECK(corner(load_posed(document, {.time = 0.5}), 1) == glm::dvec3(1.5, 0, 0));
  std::string weighted = document;
  weighted.replace(weighted.find(R"({"mesh":0})"), 10, R"({"mesh":0,"weights":[1]})");
  CHECK(corner(load_posed(weighted, {}), 2) == glm::dvec3(0, 2, 0));
  CHECK(load_posed(weighted, {}).warnings.empty());
}

TEST_CASE("what an animation cannot do is left out with a warning", "[io][gltf][pose]") {
  const auto warning = [](const std::string& document) {
    const SceneFile file = load_posed(document, {.time = 0.5});
    CHECK(corner(file, 0) == glm::dvec3(0.0));
    return file.warnings.empty() ? "" : file.warnings.front();
  };
  const std::string end = "; it is left out";
  const std::string start = "animations: channels[0]: ";
  CHECK(warning(animated("translation", "", floats({1, 1}), floats({0, 0, 0, 4, 0, 0}), 2,
                         "VEC3")) == start + "its input does not increase at key frame 1" + end);
  CHECK(warning(animated("translation", "", floats({0, 1}), floats({0, 0, 0}), 2, "VEC3")) ==
        start + "its output has 1 elements for 2 key frames" + end);
  CHECK(warning(animated("weights", "", floats({0, 1}), floats({0, 1}), 2, "SCALAR")) ==
        start + "its node has no morph targets" + end);
  CHECK(warning(animated("pointer", "", floats({0, 1}), floats({0, 1}), 2, "SCALAR")) ==
        start + "path 'pointer' is not one of glTF 2.0" + end);
}

TEST_CASE("an animation and a scene are chosen by name or number", "[io][gltf][pose]") {
  const std::string document =
      animated("translation", "", floats({0, 1}), floats({0, 0, 0, 4, 0, 0}), 2, "VEC3");
  CHECK(corner(load_posed(document, {.time = 1, .animation = "move"}), 0).x == 4.0);
  CHECK(corner(load_posed(document, {.time = 1, .animation = "0"}), 0).x == 4.0);
  CHECK_THROWS_WITH(load_posed(document, {.time = 1, .animation = "1"}),
                    Catch::EndsWith("animations: none is called '1'; the file has 1"));
  const std::string scenes = R"({"asset":{"version":"2.0"},"scene":1,"scenes":[{"nodes":[0]},
{"name":"b","nodes":[1]}],"nodes":[{"name":"one","extras":{"shape":{"type":"sphere"}}},
{"name":"two","extras":{"shape":{"type":"box"}}}]})";
  const auto name = [&](const std::string& scene) {
    return load_posed(scenes, {.scene = scene}).scene.surfaces.name(ObjectId{0});
  };
  CHECK(name("") == "two");
  CHECK(name("0") == "one");
  CHECK(name("b") == "two");
  CHECK_THROWS_WITH(name("2"), Catch::EndsWith("scenes: none is called '2'; the file has 2"));
}

// Four corners of a strip along y, the upper two of joint 1, which stands at y = 1.
std::string skinned(const std::string& rotation, const std::string& joints =
                                                     "00000000010000000100"
                                                     "000000000000") {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < joints.size(); i += 2) {
    bytes += static_cast<char>(joints[i + 1] - '0');
  }
  const std::string positions = floats({0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0});
  const std::string weights = floats({1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0.5f, 0, 0, 0});
  const std::string inverse = floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) +
                              floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  return gltf("0,1",
              R"({"mesh":0,"skin":0,"translation":[100,0,0]},{"children":[2]},
{"translation":[0,1,0],"rotation":)" +
                  rotation + "}",
              R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"mode":5}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":4,"type":"VEC4"},
{"bufferView":2,"componentType":5126,"count":4,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":2,"type":"MAT4"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":16},
{"buffer":0,"byteOffset":64,"byteLength":64},{"buffer":0,"byteOffset":128,"byteLength":128}],)" +
                  buffer_of(positions + bytes + weights + inverse));
}

// Joints of the four vertices, four each.
const std::string bent =
    "0000000000000000"
    "0100000001000000";

TEST_CASE("a skin bends a mesh, whatever its node's place and its weights' sum",
          "[io][gltf][pose]") {
  // A quarter turn about z at (0, 1, 0): (0, 2) goes to (-1, 1), and (1, 2) to (-1, 2).
  const SceneFile file = load_posed(skinned("[0,0,0.70710678118,0.70710678118]", bent), {});
  CHECK(glm::distance(corner(file, 0), glm::dvec3(0, 0, 0)) < 1e-9);
  CHECK(glm::distance(corner(file, 1), glm::dvec3(1, 0, 0)) < 1e-9);
  CHECK(glm::distance(corner(file, 2), glm::dvec3(-1, 1, 0)) < 1e-9);
  CHECK(glm::distance(corner(file, 3), glm::dvec3(-1, 2, 0)) < 1e-9);
  CHECK(file.scene.surfaces.faces() == 1);  // as at rest
  CHECK_THROWS_WITH(load_posed(skinned("[0,0,0,1]",
                                       "0200000000000000"
                                       "0100000001000000"),
                               {}),
                    Catch::EndsWith("JOINTS_0: vertex 0 is of joint 2, but the skin has 2"));
  std::string negative = skinned("[0,0,0,1]",
                                 "0/00000000000000"  // the character before 0, for -1
                                 "0100000001000000");
  const std::string unsigned_bytes = R"("componentType":5121)";
  negative.replace(negative.find(unsigned_bytes), unsigned_bytes.size(), R"("componentType":5120)");
  CHECK_THROWS_WITH(load_posed(negative, {}),
                    Catch::EndsWith("JOINTS_0: vertex 0 is of joint -1, but the skin has 2"));
}

}  // namespace
}  // namespace raycat
