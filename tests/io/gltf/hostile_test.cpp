#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

std::string glb_error(const std::string& bytes) {
  const std::string prefix = "scene.glb: ";
  const std::string message = load_error("scene.glb", bytes);
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

const std::string json = R"({"asset":{"version":"2.0"}})";

// One triangle without indices, whose sections a test spoils.
std::string triangle(const std::string& accessor, const std::string& view,
                     const std::string& buffer) {
  return gltf("0", R"({"mesh":0})",
              R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)" +
                  accessor + R"(],"bufferViews":[)" + view + R"(],"buffers":[)" + buffer + "]");
}

const std::string positions = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";
const std::string view = R"({"buffer":0,"byteLength":36})";
const std::string zeros = R"({"byteLength":36,"uri":"data:,)" + std::string(36, '0') + R"("})";

TEST_CASE("a spoiled GLB is refused at the byte", "[io][gltf]") {
  CHECK(glb_error("glTF") == "byte 4: the GLB header is cut short");
  CHECK(glb_error("glTF" + le32(1) + le32(20) + glb_chunk("JSON", "")) ==
        "byte 4: GLB version 1 is not supported, only 2");
  CHECK(glb_error("glTF" + le32(2) + le32(4000000000u) + glb_chunk("JSON", json)) ==
        "byte 8: the GLB header says 4000000000 bytes, but the file has 47");
  CHECK(glb_error(glb(le32(4294967295u) + "JSON" + json)) ==
        "byte 12: a GLB chunk of 4294967295 bytes overruns the 27 that are left");
  CHECK(glb_error(glb(glb_chunk("ABCD", json))) ==
        "byte 16: the first chunk of the GLB is not JSON");
  CHECK(glb_error(glb(glb_chunk("JSON", json.substr(1)))) == "byte 27: not JSON");
  CHECK(glb_error(glb(glb_chunk("JSON", json))).empty());
}

TEST_CASE("JSON that would overflow a stack is refused", "[io][gltf]") {
  CHECK(gltf_error(std::string(100000, '[')) == "byte 256: JSON is nested more than 256 deep");
  CHECK(gltf_error(R"({"asset":{"version":"2.0","extras":)" + std::string(100000, '[') +
                   std::string(100000, ']') + "}}") ==
        "byte 289: JSON is nested more than 256 deep");
}

TEST_CASE("a wrong type is one clear line", "[io][gltf]") {
  CHECK(gltf_error("[]") == "JSON: expected an object");
  CHECK(gltf_error("{}") == "asset: is missing");
  CHECK(gltf_error(R"({"asset":{"version":"1.0"}})") ==
        "asset: glTF version 1.0 is not supported, only 2.0");
  CHECK(gltf_error(gltf("0", R"({"name":"n","mesh":"x"})")) ==
        "node 0 'n': mesh: expected an index, but found \"x\"");
  CHECK(gltf_error(gltf("0", R"({"scale":[1,2]})")) ==
        "node 0: scale: expected 3 numbers, but found [1,2]");
  CHECK(gltf_error(gltf("7", "{}")) == "scenes[0]: nodes[0]: there is no nodes[7]; the file has 1");
  CHECK(gltf_error(R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_texture_basisu"]})") ==
        "extensionsRequired: extension 'KHR_texture_basisu' is required but not supported");
}

TEST_CASE("nodes must be a forest", "[io][gltf]") {
  CHECK(gltf_error(gltf("0", R"({"children":[1]},{"children":[0]})")) ==
        "node 0: the node is on or below a cycle of children");
  CHECK(gltf_error(gltf("0", R"({"children":[2]},{"children":[2]},{"name":"x"})")) ==
        "node 2 'x': has two parents, nodes 0 and 1");
}

TEST_CASE("accessors past their data are refused before they are read", "[io][gltf]") {
  CHECK(gltf_error(triangle(positions, view, zeros)).empty());
  CHECK(gltf_error(triangle(
            R"({"bufferView":0,"componentType":5126,"count":9007199254740991,"type":"VEC3"})", view,
            zeros)) ==
        "accessors[0]: 9007199254740991 elements of 12 bytes from byte 0 overrun the 36 of "
        "bufferViews[0]");
  CHECK(gltf_error(triangle(R"({"componentType":5126,"count":9007199254740991,"type":"VEC3"})",
                            view, zeros))
            .find("that --max-memory allows") != std::string::npos);
  CHECK(gltf_error(triangle(
            positions, R"({"buffer":0,"byteOffset":9007199254740991,"byteLength":36})", zeros)) ==
        "bufferViews[0]: 36 bytes from 9007199254740991 overrun the 36 of buffers[0]");
  CHECK(gltf_error(triangle(positions, view, R"({"byteLength":36,"uri":"data:,0"})")) ==
        "buffers[0]: 36 bytes are declared, but there are 1");
  CHECK(gltf_error(triangle(positions, view, R"({"byteLength":36})")) ==
        "accessors[0]: bufferViews[0] is of buffers[0], which has no data");
}

TEST_CASE("URIs do not lead out of the folder", "[io][gltf]") {
  const auto error = [](const std::string& uri) {
    return gltf_error(triangle(positions, view, R"({"byteLength":36,"uri":")" + uri + R"("})"));
  };
  const std::string out = "leads out of the file's folder";
  CHECK_THAT(error("../a.bin"), Catch::EndsWith(out));
  CHECK_THAT(error("%2e%2e%2fa.bin"), Catch::EndsWith(out));
  CHECK_THAT(error("a/../../a.bin"), Catch::EndsWith(out));
  CHECK_THAT(error("/etc/passwd"), Catch::EndsWith(out));
  CHECK_THAT(error("file:///etc/passwd"),
             Catch::EndsWith("has a scheme; only relative URIs are read"));
  CHECK_THAT(error("a\\\\b.bin"), Catch::EndsWith("holds a character that is not allowed"));
  CHECK_THAT(error("a%00b.bin"), Catch::EndsWith("holds a character that is not allowed"));
  CHECK(error("none.bin") == "buffers[0]: 'none.bin': no such file");
}

TEST_CASE("a pipe is not opened", "[io][gltf]") {
  const auto pipe = temporary_folder() / "pipe.bin";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(gltf_error(triangle(positions, view, R"({"byteLength":36,"uri":"pipe.bin"})")) ==
        "buffers[0]: 'pipe.bin': is not a regular file");
  std::filesystem::remove_all(pipe.parent_path());
}

}  // namespace
}  // namespace raycat
