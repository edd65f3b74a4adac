#include "io/gltf/primitive.hpp"

#include <catch2/catch.hpp>

#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

// A node with one primitive, whose accessors are into one buffer of `bytes`.
std::string primitive_text(const std::string& primitive, const std::string& accessors,
                           const std::string& views, const std::string& bytes,
                           const std::string& more = "") {
  return gltf("0", R"({"mesh":0})",
              R"(,"meshes":[{"primitives":[{)" + primitive + R"(}]}],"accessors":[)" + accessors +
                  R"(],"bufferViews":[)" + views + "]," + buffer_of(bytes) + more);
}

std::string view_text(std::size_t offset, std::size_t length, const std::string& more = "") {
  return R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
         std::to_string(length) + more + "}";
}

SurfaceMesh load(const std::string& text) {
  const SceneFile file = load_text("scene.gltf", text);
  CHECK(file.warnings.empty());
  return *file.scene.meshes.at(0).mesh;
}

const std::string five_points = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});

std::vector<glm::uvec3> triangles(const std::string& mode) {
  return load(primitive_text(R"("mode":)" + mode + R"(,"attributes":{"POSITION":0})",
                             R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})",
                             view_text(0, 60), five_points))
      .triangles.triangles;
}

TEST_CASE("strips and fans wind as glTF 2.0 says", "[io][gltf]") {
  CHECK(triangles("5") == std::vector<glm::uvec3>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  CHECK(triangles("6") == std::vector<glm::uvec3>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
}

TEST_CASE("points and lines are left out with a warning", "[io][gltf]") {
  const auto file =
      load_text("scene.gltf",
                primitive_text(R"("mode":1,"attributes":{"POSITION":0})",
                               R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})",
                               view_text(0, 60), five_points));
  CHECK(file.scene.meshes.empty());
  CHECK(file.scene.surfaces.objects() == 0);
  CHECK(file.warnings ==
        std::vector<std::string>{
            "primitives of points or lines, which have no surface, are not drawn: 1"});
}

TEST_CASE("a sparse accessor replaces the elements that it names", "[io][gltf]") {
  const std::string patch =
      std::string("\0\2", 2) + std::string(2, '\0') + floats({9, 9, 9, 7, 7, 8});
  const std::string sparse = R"("count":3,"type":"VEC3","sparse":{"count":2,
      "indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}})";
  const std::string views = view_text(0, 36) + "," + view_text(60, 2) + "," + view_text(64, 24);
  const auto positions = [&](const std::string& accessor) {
    return load(primitive_text(R"("attributes":{"POSITION":0})", accessor + sparse, views,
                               five_points + patch))
        .triangles.positions;
  };
  CHECK(positions(R"({"bufferView":0,"componentType":5126,)") ==
        std::vector<glm::dvec3>{{9, 9, 9}, {1, 0, 0}, {7, 7, 8}});
  // Without a buffer view the rest is zero.
  CHECK(positions(R"({"componentType":5126,)") ==
        std::vector<glm::dvec3>{{9, 9, 9}, {0, 0, 0}, {7, 7, 8}});
}

TEST_CASE("a sparse index past the elements is refused", "[io][gltf]") {
  CHECK(gltf_error(
            primitive_text(R"("attributes":{"POSITION":0})",
                           R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
              "indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":1}}})",
                           view_text(0, 1) + "," + view_text(4, 12),
                           std::string("\3\0\0\0", 4) + floats({1, 2, 3}))) ==
        "accessors[0]: sparse index 3 is past the 3 elements");
}

TEST_CASE("quantized positions are whole numbers, or normalized to [-1, 1]", "[io][gltf]") {
  const std::string bytes =
      std::string("\x7f\0\0\0", 4) + std::string("\0\x81\0\0", 4) + std::string("\0\0\x80\0", 4);
  const auto positions = [&](const std::string& normalized) {
    return load(primitive_text(R"("attributes":{"POSITION":0})",
                               R"({"bufferView":0,"componentType":5120,"count":3,"type":"VEC3")" +
                                   normalized + "}",
                               view_text(0, 12, R"(,"byteStride":4)"), bytes,
                               R"(,"extensionsRequired":["KHR_mesh_quantization"])"))
        .triangles.positions;
  };
  CHECK(positions("") == std::vector<glm::dvec3>{{127, 0, 0}, {0, -127, 0}, {0, 0, -128}});
  CHECK(positions(R"(,"normalized":true)") ==
        std::vector<glm::dvec3>{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}});
}

TEST_CASE("an index past the vertices is refused", "[io][gltf]") {
  const auto error = [](char last) {
    return gltf_error(primitive_text(
        R"("attributes":{"POSITION":0},"indices":1)",
        R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"},
           {"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"})",
        view_text(0, 60) + "," + view_text(60, 3), five_points + std::string("\0\1", 2) + last));
  };
  CHECK(error('\4').empty());
  CHECK(error('\5') == "meshes[0]: primitives[0]: indices: index 5 at 2 is past the 5 vertices");
}

}  // namespace
}  // namespace raycat
