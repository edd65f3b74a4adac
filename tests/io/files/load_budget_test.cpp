#include "io/files/load_budget.hpp"

#include <catch2/catch.hpp>

#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

std::string error_with(const LoadLimits& limits, std::string_view document) {
  const TemporaryFile file("scene.gltf", document);
  try {
    load_scene(file.path(), {.limits = limits});
  } catch (const LoadError& error) {
    const std::string message = error.what();
    return message.substr(message.find("scene.gltf: ") + 12);
  }
  return "";
}

// Two instances of a square of two triangles.
const std::string squares =
    gltf("0,1", R"({"mesh":0},{"mesh":0,"translation":[2,0,0]})",
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":48}],)" +
             buffer_of(floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})));

TEST_CASE("what a file may take is limited, and the limit says its option", "[io][gltf][budget]") {
  CHECK(error_with({}, squares).empty());
  CHECK(error_with({.nodes = 2}, squares).empty());
  CHECK(error_with({.nodes = 1}, squares) ==
        "nodes: needs 2 nodes where 1 are left of the 1 that --max-nodes allows");
  CHECK(error_with({.instances = 2}, squares).empty());
  CHECK(error_with({.instances = 1}, squares) ==
        "node 1: needs 1 instances where 0 are left of the 1 that --max-instances allows");
  CHECK(error_with({.triangles = 4}, squares).empty());
  CHECK(error_with({.triangles = 3}, squares) ==
        "node 1: needs 2 triangles where 1 are left of the 3 that --max-triangles allows");
  CHECK(error_with({.memory = 10}, squares).find(" that --max-memory allows") != std::string::npos);
}

TEST_CASE("bombs are refused before they take room", "[io][gltf][budget]") {
  const auto mesh = [](const std::string& accessor) {
    return gltf("0", R"({"mesh":0})",
                R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)" +
                    accessor + "]");
  };
  const LoadLimits limits{.memory = std::uint64_t{1} << 24};
  CHECK(error_with(limits, mesh(R"({"componentType":5126,"count":1000000000000,"type":"VEC3"})"))
            .starts_with("accessors[0]: needs 12000000000000 bytes where "));
  CHECK(error_with(limits, mesh(R"({"componentType":5126,"count":9007199254740991,"type":"MAT4"})"))
            .find("--max-memory") != std::string::npos);
  std::string nodes = "{}";
  for (int i = 0; i < 200'000; ++i) {
    nodes += ",{}";
  }
  CHECK(error_with(limits, gltf("0", nodes)).find("--max-memory") != std::string::npos);
}

}  // namespace
}  // namespace raycat
