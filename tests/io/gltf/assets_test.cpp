#include "io/gltf/assets.hpp"

#include <catch2/catch.hpp>

#include "io/scene/closed_scene.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

const std::string tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

SceneFile load(const std::string& document) { return load_text("scene.gltf", document); }

std::string placing(const std::string& uri, const std::string& more = "") {
  return gltf("0", R"({"name":"part","translation":[0,0,5],"extras":{"asset":{"uri":")" + uri +
                       R"(")" + more + "}}}");
}

std::string cutting(const std::string& uri) {
  return gltf("0", R"({"name":"cut","extras":{"csg":"difference"},"children":[1,2]},
      {"extras":{"shape":{"type":"box","size":[4,4,4]}}},
      {"name":"tool","extras":{"asset":{"uri":")" +
                       uri + R"("}}})");
}

TEST_CASE("a mesh file is placed as an object", "[io][gltf]") {
  const TemporaryFile part("part.obj", tetrahedron);
  const auto file = load(placing("part.obj"));
  REQUIRE(file.scene.meshes.size() == 1);
  CHECK(file.scene.meshes[0].transform.point({0, 0, 0}) == glm::dvec3(0, 0, 5));
  CHECK(file.scene.surfaces.name(ObjectId{0}) == "part");
  CHECK(file.triangles == 4);
  CHECK(is_closed(file.scene));
}

TEST_CASE("a mesh file is an operand if it encloses a volume", "[io][gltf]") {
  const TemporaryFile part("part.obj", tetrahedron);
  const auto file = load(cutting("part.obj"));
  REQUIRE(file.scene.solids.size() == 1);
  CHECK(file.scene.surfaces.primitives() == 2);
  CHECK(file.scene.surfaces.faces() == 6 + 4);
  CHECK(file.csg_nodes == 3);
  const TemporaryFile open("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK_THAT(gltf_error(cutting("open.obj")), Catch::StartsWith("node 2 'tool': "));
}

TEST_CASE("a .csg file is placed as an object and as an operand", "[io][gltf]") {
  const TemporaryFile part("part.csg", "difference() { cube(2); cube(1); }");
  const auto placed = load(placing("part.csg"));
  REQUIRE(placed.scene.solids.size() == 1);
  CHECK(placed.csg_nodes == 3);
  CHECK(placed.scene.solids[0].solid.bounds() == Bounds{.min = {0, 0, 5}, .max = {2, 2, 7}});
  const auto cut = load(cutting("part.csg"));
  REQUIRE(cut.scene.solids.size() == 1);
  const auto nodes = cut.scene.solids[0].solid.tree().nodes();
  REQUIRE(nodes.size() == 5);
  CHECK(nodes[3].operation == Operation::difference);
  CHECK(nodes[3].subtracted);
  CHECK(cut.scene.solids[0].materials.size() == 3);
}

TEST_CASE("files that place each other in a circle are refused", "[io][gltf]") {
  const TemporaryFile other("other.gltf", placing("scene.gltf"));
  CHECK(load_error("scene.gltf", placing("other.gltf")) ==
        "scene.gltf: node 0 'part': extras.asset: 'other.gltf' places itself");
}

TEST_CASE("a circle is seen whatever the files are called", "[io][gltf]") {
  CHECK(load_error("scene.GLTF", placing("scene.GLTF")) ==
        "scene.GLTF: node 0 'part': extras.asset: 'scene.GLTF' places itself");
  CHECK(load_error("scene.bin", glb(glb_chunk("JSON", placing("scene.bin")))) ==
        "scene.bin: node 0 'part': extras.asset: 'scene.bin' places itself");
}

TEST_CASE("a file may place a node of its own", "[io][gltf]") {
  const auto file = load(gltf("0", R"({"name":"copy","extras":{"asset":{"uri":"scene.gltf",
      "node":"ball"}}},{"name":"ball","extras":{"shape":{"type":"sphere"}}})"));
  CHECK(file.scene.solids.size() == 1);
  CHECK(file.scene.surfaces.name(ObjectId{0}) == "copy");
}

TEST_CASE("an asset that is not there is named", "[io][gltf]") {
  const TemporaryFile part("part.obj", tetrahedron);
  CHECK_THAT(gltf_error(placing("none.glb")), Catch::EndsWith("none.glb: no such file"));
  CHECK(gltf_error(placing("part.obj", R"(,"node":"a")")) ==
        "node 0 'part': extras.asset: 'part.obj' has no named nodes; only .gltf and .glb have");
  CHECK(gltf_error(placing("scene.gltf", R"(,"node":"ball")")) == "nodes: no node is named 'ball'");
}

TEST_CASE("a symbolic link out of the folder is refused", "[io][gltf]") {
  const auto link = temporary_folder() / "link.obj";
  std::filesystem::create_symlink("/etc/hostname", link);
  CHECK(gltf_error(placing("link.obj")) ==
        "node 0 'part': extras.asset: URI 'link.obj' leads out of the file's folder");
  std::filesystem::remove_all(link.parent_path());
}

TEST_CASE("an open mesh is no operand, and is named", "[io][gltf]") {
  const std::string more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[
      {"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
      "bufferViews":[{"buffer":0,"byteLength":36}],)" +
      buffer_of(floats({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  CHECK_THAT(gltf_error(gltf("0", R"({"extras":{"csg":"union"},"children":[1]},
                             {"name":"sail","mesh":0})",
                             more)),
             Catch::StartsWith("node 1 'sail': ") && Catch::Contains("is open; 3 edges are"));
}

}  // namespace
}  // namespace raycat
