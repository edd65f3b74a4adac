// Meshes as operands of CSG trees, in any file format and place, and what ids shared parts have.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/io/gltf/text.hpp"
#include "tracer/scene_crossings.hpp"

namespace raycat {
namespace {

SceneFile load(const std::string& document) { return load_text("scene.gltf", document); }

constexpr std::array<std::array<int, 3>, 8> corners{{{-1, -1, -1},
                                                     {1, -1, -1},
                                                     {-1, 1, -1},
                                                     {1, 1, -1},
                                                     {-1, -1, 1},
                                                     {1, -1, 1},
                                                     {-1, 1, 1},
                                                     {1, 1, 1}}};
// From 0, counter-clockwise from outside: -z, +z, -y, +y, -x, +x, two triangles each.
constexpr std::array<std::array<int, 3>, 12> triangles{{{0, 2, 3},
                                                        {0, 3, 1},
                                                        {4, 5, 7},
                                                        {4, 7, 6},
                                                        {0, 1, 5},
                                                        {0, 5, 4},
                                                        {2, 6, 7},
                                                        {2, 7, 3},
                                                        {0, 4, 6},
                                                        {0, 6, 2},
                                                        {1, 3, 7},
                                                        {1, 7, 5}}};

// A cube from -1 to 1, of which the last `missing` triangles are left out.
std::string cube(const std::string& format, std::size_t missing = 0) {
  const std::size_t count = triangles.size() - missing;
  std::string text = format == "off"   ? fmt::format("OFF\n8 {} 0\n", count)
                     : format == "stl" ? "solid cube\n"
                     : format == "ply" ? fmt::format(
                                             "ply\nformat ascii 1.0\nelement vertex 8\n"
                                             "property double x\nproperty double y\n"
                                             "property double z\nelement face {}\n"
                                             "property list uchar int vertex_indices\n"
                                             "end_header\n",
                                             count)
                                       : "";
  if (format != "stl") {
    for (const auto& p : corners) {
      text += fmt::format("{}{} {} {}\n", format == "obj" ? "v " : "", p[0], p[1], p[2]);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto& t = triangles[i];
    if (format == "stl") {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int k : t) {
        const auto& p = corners[static_cast<std::size_t>(k)];
        text += fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
      }
      text += "endloop\nendfacet\n";
    } else if (format == "obj") {
      text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    } else {
      text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
    }
  }
  return text + (format == "stl" ? "endsolid cube\n" : "");
}

// The same cube as mesh 0 of a glTF document.
std::string cube_mesh(std::size_t missing = 0) {
  std::string bytes;
  for (std::size_t i = 0; i + missing < triangles.size(); ++i) {
    for (const int k : triangles[i]) {
      for (const int x : corners[static_cast<std::size_t>(k)]) {
        bytes += floats({static_cast<float>(x)});
      }
    }
  }
  return fmt::format(
             R"(,"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"accessors":[
             {{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}}],
             "bufferViews":[{{"buffer":0,"byteLength":{}}}],)",
             bytes.size() / 12, bytes.size()) +
         buffer_of(bytes);
}

struct Met {
  double t;
  std::string primitive;
  std::uint32_t face;
  bool operator==(const Met&) const = default;
};

std::vector<Met> along(const Scene& scene, const Ray& ray) {
  const SceneCrossings crossings(scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> found;
  crossings.cross(ray, scratch, found);
  std::vector<Met> met;
  for (const SceneCrossing& crossing : found) {
    met.push_back({.t = crossing.t,
                   .primitive = scene.surfaces.name(scene.surfaces.primitive(crossing.surface)),
                   .face = scene.surfaces.face_in_primitive(crossing.surface)});
  }
  return met;
}

std::vector<double> places(const std::vector<Met>& met) {
  std::vector<double> t;
  for (const Met& each : met) {
    t.push_back(each.t);
  }
  return t;
}

// An operand node, the cube as `asset` of a file, as glTF's own mesh, or as a box.
std::string operand(const std::string& form, const std::string& more) {
  const std::string what = form == "mesh"  ? R"("mesh":0)"
                           : form == "box" ? R"("extras":{"shape":{"type":"box","size":[2,2,2]}})"
                                           : R"("extras":{"asset":{"uri":"cube.)" + form + R"("}})";
  return "{" + what + more + "}";
}

TEST_CASE("a closed mesh of any format is an operand in any place", "[io][gltf][csg]") {
  const std::string form = GENERATE("obj", "ply", "stl", "off", "mesh", "box");
  const TemporaryFile file("cube." + form, form.size() == 3 ? cube(form) : "");
  const std::string ball = R"({"extras":{"shape":{"type":"sphere","radius":1.25}}})";
  const std::string more = form == "mesh" ? cube_mesh() : "";
  // Through the middle of faces, along an edge between two triangles, and near a corner.
  const Ray ray = GENERATE(Ray{.origin = {0.25, 0.125, 8}, .direction = {0, 0, -1}},
                           Ray{.origin = {0.5, 0.5, 8}, .direction = {0, 0, -1}},
                           Ray{.origin = {0, 0, 8}, .direction = {0, 0, -2}});
  const double scale = -1.0 / ray.direction.z;
  const double half =
      std::sqrt(1.25 * 1.25 - ray.origin.x * ray.origin.x - ray.origin.y * ray.origin.y);
  const auto expect = [&](const std::string& nodes, std::vector<double> z) {
    INFO(form << ": " << nodes);
    const std::vector<double> t = places(along(load(gltf("0", nodes, more)).scene, ray));
    REQUIRE(t.size() == z.size());
    for (std::size_t i = 0; i < z.size(); ++i) {
      CHECK(t[i] == Approx((8.0 - z[i]) * scale).margin(1e-12));
    }
  };
  const std::string two = R"(,"children":[1,2]},)";
  const std::string cut = R"({"extras":{"csg":"difference"})" + two;
  expect(cut + operand(form, "") + "," + ball, {});
  expect(cut + ball + "," + operand(form, ""), {half, 1, -1, -half});
  expect(R"({"extras":{"csg":"intersection"})" + two + operand(form, "") + "," + ball, {1, -1});
  expect(R"({"extras":{"csg":"union"})" + two + operand(form, "") + "," + ball, {half, -half});
  // Nested, moved and mirrored: the ball without the cube's upper half, in a cube.
  expect(R"({"extras":{"csg":"intersection"},"children":[1,2]},)" +
             operand(form, R"(,"scale":[1,1,-1])") +
             R"(,{"extras":{"csg":"difference"},"children":[3,4]},)" + ball + "," +
             operand(form, R"(,"translation":[0,0,1])"),
         {0, -1});
}

TEST_CASE("an open operand is one line that says where its hole is", "[io][gltf][csg]") {
  const std::string tree = R"({"extras":{"csg":"difference"},"children":[1,2]},
      {"extras":{"shape":{"type":"sphere"}}},)";
  for (const std::string form : {"obj", "ply", "stl", "off", "mesh"}) {
    const TemporaryFile file("cube." + form, form == "mesh" ? "" : cube(form, 1));
    const std::string error = gltf_error(
        gltf("0", tree + operand(form, R"(,"name":"tool")"), form == "mesh" ? cube_mesh(1) : ""));
    CAPTURE(form, error);
    CHECK_THAT(error, Catch::StartsWith("node 2 'tool': "));
    CHECK_THAT(error,
               Catch::Contains("edge (1, ") && Catch::Contains(" is open; 3 edges are open"));
    CHECK(error.find('\n') == std::string::npos);
  }
}

TEST_CASE("a mesh shared by nodes gives distinct primitives with the same faces", "[io][gltf]") {
  const SceneFile file = load(gltf("0,3", R"(
      {"name":"cut","extras":{"csg":"union"},"children":[1,2]},
      {"name":"low","mesh":0},{"name":"high","mesh":0,"translation":[0,0,4]},
      {"name":"alone","mesh":0,"translation":[0,0,8]})",
                                   cube_mesh()));
  const auto met = along(file.scene, {.origin = {0.25, 0.5, -9}, .direction = {0, 0, 1}});
  REQUIRE(met.size() == 6);
  CHECK(places(met) == std::vector<double>{8, 10, 12, 14, 16, 18});
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(met[2 * i].primitive == std::array{"low", "high", "alone"}[i]);
    CHECK(met[2 * i].face == met[0].face);
    CHECK(met[2 * i + 1].face == met[1].face);
  }
  CHECK(file.scene.surfaces.faces() == 18);
}

TEST_CASE("a tree placed many times is as many objects with the same faces", "[io][gltf]") {
  const TemporaryFile part("part.gltf", gltf("0", R"(
      {"name":"block","extras":{"csg":"difference"},"children":[1,2]},
      {"name":"body","extras":{"shape":{"type":"box","size":[2,2,2]}}},
      {"name":"slot","extras":{"csg":"union"},"children":[3,4]},
      {"name":"wide","extras":{"shape":{"type":"box","size":[1,4,1]}}},
      {"name":"long","extras":{"shape":{"type":"box","size":[0.5,4,1.5]}}})"));
  constexpr int copies = 50;
  std::string roots;
  std::string nodes;
  for (int i = 0; i < copies; ++i) {
    roots += fmt::format("{}{}", i == 0 ? "" : ",", i);
    nodes += fmt::format(R"({}{{"name":"copy","translation":[0,0,{}],
        "extras":{{"asset":{{"uri":"part.gltf"}}}}}})",
                         i == 0 ? "" : ",", 4 * i);
  }
  const SceneFile file = load(gltf(roots, nodes));
  const SurfaceTable& surfaces = file.scene.surfaces;
  REQUIRE(surfaces.objects() == copies);
  CHECK(surfaces.primitives() == 3 * copies);
  CHECK(surfaces.name(ObjectId{7}) == "copy (8)");

  const SceneCrossings crossings(file.scene);
  Solid::Scratch scratch;
  std::vector<SceneCrossing> met;
  crossings.cross({.origin = {0.125, 0, -9}, .direction = {0, 0, 1}}, scratch, met);
  REQUIRE(met.size() == 4 * copies);
  for (std::size_t i = 0; i < met.size(); ++i) {
    // Into the body, out of it through the long slot, and so on.
    CHECK(surfaces.object(met[i].surface) == static_cast<ObjectId>(i / 4));
    const auto first = static_cast<std::uint32_t>(18 * (i / 4));
    CHECK(static_cast<std::uint32_t>(met[i].surface) - first ==
          std::array{4u, 12u + 4u, 12u + 5u, 5u}[i % 4]);
  }
}

TEST_CASE("the outermost cut_material counts", "[io][gltf]") {
  // ((0 - 1) - (2 - (3 - 4))) - 5, materials by leaf; which differences say "base" varies.
  const auto materials = [](bool first, bool second, bool third, bool fourth) {
    const auto cut = [](bool base, const std::string& children) {
      return R"({"extras":{"csg":"difference","cut_material":")" +
             std::string(base ? "base" : "operand") + R"("},"children":[)" + children + "]}";
    };
    std::string nodes = cut(first, "1,9") + "," + cut(second, "2,3") + "," + cut(third, "4,5") +
                        "," + cut(fourth, "6,10") +
                        R"(,{"extras":{"shape":{"type":"box"},"material":0}},
        {"extras":{"shape":{"type":"box"},"material":1}},
        {"extras":{"shape":{"type":"box"},"material":2}},
        {"extras":{"shape":{"type":"box"},"material":3}},
        {"extras":{"shape":{"type":"box"},"material":4}},
        {"extras":{"shape":{"type":"box"},"material":5}},
        )" + cut(false, "7,8");
    const SceneFile file = load(gltf("0", nodes, R"(,"materials":[{},{},{},{},{},{}])"));
    std::vector<int> found;
    for (const MaterialId id : file.scene.solids[0].materials) {
      found.push_back(static_cast<int>(id));
    }
    return found;
  };
  using List = std::vector<int>;
  CHECK(materials(false, false, false, false) == List{0, 1, 2, 3, 4, 5});
  CHECK(materials(true, false, false, false) == List{0, 1, 2, 3, 4, 0});
  CHECK(materials(false, true, false, false) == List{0, 1, 0, 0, 0, 5});
  CHECK(materials(false, false, true, false) == List{0, 0, 2, 3, 4, 5});
  CHECK(materials(false, false, false, true) == List{0, 1, 2, 2, 2, 5});
  CHECK(materials(false, true, false, true) == List{0, 1, 0, 0, 0, 5});
  CHECK(materials(true, false, true, true) == List{0, 0, 2, 2, 2, 0});
}

TEST_CASE("cuts in cuts are covered to any depth", "[io][gltf]") {
  constexpr int depth = 20'000;
  std::string nodes;
  for (int i = 0; i < depth; ++i) {
    nodes += fmt::format(R"({{"extras":{{"csg":"difference","cut_material":"base"}},
        "children":[{},{}]}},{{"extras":{{"shape":{{"type":"sphere"}},"material":{}}}}},)",
                         2 * i + 1, 2 * i + 2, i % 2);
  }
  nodes += R"({"extras":{"shape":{"type":"box"},"material":1}})";
  const auto file = load(gltf("0", nodes, R"(,"materials":[{},{}])"));
  const std::vector<MaterialId>& materials = file.scene.solids[0].materials;
  CHECK(materials == std::vector(depth + 1, MaterialId{0}));
}

}  // namespace
}  // namespace raycat
