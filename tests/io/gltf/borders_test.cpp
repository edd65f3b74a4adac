#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

// A flat strip of two squares, as four triangles of six vertices:
//
//   3 - 4 - 5
//   | / | / |
//   0 - 1 - 2
std::string strip(const std::string& extension, const std::string& more = "") {
  const std::string corners = floats({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0});
  const std::string indices("\0\1\4\0\4\3\1\2\5\1\5\4", 12);
  const std::string numbers("\1\4\0\4\0\6\3\0", 8);  // pairs, then offsets
  return gltf("0", R"({"mesh":0})",
              fmt::format(
                  R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,
"extensions":{{{}}}}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"}},
{{"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}},
{{"bufferView":1,"byteOffset":12,"componentType":5121,"count":2,"type":"SCALAR"}},
{{"bufferView":1,"byteOffset":14,"componentType":5121,"count":2,"type":"SCALAR"}},
{{"bufferView":1,"byteOffset":16,"componentType":5121,"count":3,"type":"SCALAR"}},
{{"bufferView":1,"byteOffset":16,"componentType":5121,"count":2,"type":"SCALAR"}},
{{"bufferView":1,"byteOffset":12,"componentType":5120,"count":2,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":72}},{{"buffer":0,"byteOffset":72,"byteLength":20}}],{}{})",
                  extension, buffer_of(corners + indices + numbers), more));
}

std::vector<std::uint32_t> faces(const std::string& document) {
  const SceneFile file = load_text("scene.gltf", document);
  CHECK(file.warnings.empty());
  return file.scene.meshes.at(0).mesh->triangles.faces;
}

using Faces = std::vector<std::uint32_t>;

TEST_CASE("an outline parts faces where it is drawn, and nowhere else", "[io][gltf][borders]") {
  CHECK(faces(strip("")) == Faces{0, 0, 0, 0});
  CHECK(faces(strip(R"("CESIUM_primitive_outline":{"indices":2})")) == Faces{0, 0, 1, 1});
  CHECK(faces(strip(R"("CESIUM_primitive_outline":{"indices":3})")) == Faces{0, 1, 0, 0});
  // Signed, as the extension's own sample has them.
  CHECK(faces(strip(R"("CESIUM_primitive_outline":{"indices":6})")) == Faces{0, 0, 1, 1});
}

TEST_CASE("polygons are faces, by offsets or by the fan's first vertex", "[io][gltf][borders]") {
  CHECK(faces(strip(R"("EXT_mesh_polygon":{"count":2,"indicesOffsets":5})")) == Faces{0, 0, 1, 1});
  CHECK(faces(strip(R"("FB_ngon_encoding":{})")) == Faces{0, 0, 1, 1});
  CHECK(faces(strip("", R"(,"extensionsUsed":["FB_ngon_encoding"])")) == Faces{0, 0, 1, 1});
}

TEST_CASE("borders that cannot be read are left out with a warning", "[io][gltf][borders]") {
  const auto warning = [](const std::string& extension) {
    const SceneFile file = load_text("scene.gltf", strip(extension));
    CHECK(file.scene.meshes.at(0).mesh->triangles.faces == Faces{0, 0, 0, 0});
    return file.warnings.empty() ? "" : file.warnings.front();
  };
  CHECK(warning(R"("CESIUM_primitive_outline":{"indices":4})") ==
        "meshes[0]: primitives[0]: CESIUM_primitive_outline: indices are no pairs of vertices, and "
        "it is ignored");
  CHECK(warning(R"("CESIUM_primitive_outline":{"indices":0})") ==
        "meshes[0]: primitives[0]: CESIUM_primitive_outline: indices are no pairs of vertices, and "
        "it is ignored");
  CHECK(warning(R"("EXT_mesh_polygon":{"count":1,"indicesOffsets":2})") ==
        "meshes[0]: primitives[0]: EXT_mesh_polygon: indicesOffsets do not cut the indices into "
        "polygons, and it is ignored");
}

}  // namespace
}  // namespace raycat
