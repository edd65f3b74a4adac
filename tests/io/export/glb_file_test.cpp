#include "io/export/glb_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "io/export/object_mesh.hpp"
#include "io/load_scene.hpp"
#include "io/scene/closed_scene.hpp"
#include "tests/io/scene_text.hpp"
#include "tracer/scene_crossings.hpp"

namespace raycat {
namespace {

using Json = nlohmann::json;

constexpr const char* bracket = R"csg(
color([0.2, 0.4, 0.8, 1]) {
  difference() {
    cube(size = [20, 20, 10], center = false);
    multmatrix([[1, 0, 0, 10], [0, 1, 0, 10], [0, 0, 1, -1], [0, 0, 0, 1]]) {
      cylinder($fn = 24, h = 12, r1 = 4, r2 = 4, center = false);
    }
    multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]) {
      cube(size = [20, 6, 5], center = false);
    }
  }
}
multmatrix([[1, 0, 0, 40], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
  color([1, 0, 0, 1]) { sphere($fn = 16, r = 5); }
  color([0, 1, 0, 1]) { cube(size = [8, 2, 2], center = false); }
}
)csg";

struct Converted {
  SceneFile file;
  std::string bytes;
  std::vector<std::string> warnings;
};

Converted converted(const Scene& scene, double chord_error = 1e-3) {
  const TemporaryFile place("out.glb", "");
  Converted out;
  write_glb(place.path(), scene, object_meshes(scene, chord_error), out.warnings);
  out.file = load_scene(place.path());
  std::ifstream in(place.path(), std::ios::binary);
  out.bytes.assign(std::istreambuf_iterator<char>(in), {});
  return out;
}

Json document(const std::string& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  return Json::parse(bytes.substr(20, length));
}

std::string name_of(const SurfaceTable& surfaces, SurfaceId face) {
  return surfaces.name(surfaces.object(face)) + " / " + surfaces.name(surfaces.primitive(face)) +
         " / " + std::to_string(surfaces.face_in_primitive(face));
}

// Along random lines, are the crossings those of the other scene, with the same names and numbers?
void check_same_crossings(const Scene& a, const Scene& b, double tolerance, int least) {
  const SceneCrossings of_a(a);
  const SceneCrossings of_b(b);
  const Bounds box = bounds(a);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] {
    return box.center() + glm::dvec3(unit(random), unit(random), unit(random)) * box.half_size();
  };
  Solid::Scratch scratch;
  std::vector<SceneCrossing> first;
  std::vector<SceneCrossing> second;
  int crossings = 0;
  int different = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 origin = point();
    const Ray ray{.origin = origin, .direction = glm::normalize(point() - origin)};
    of_a.cross(ray, scratch, first);
    of_b.cross(ray, scratch, second);
    bool same = first.size() == second.size();
    for (std::size_t k = 0; same && k < first.size(); ++k) {
      same = std::abs(first[k].t - second[k].t) < tolerance &&
             first[k].entering == second[k].entering && first[k].surface == second[k].surface &&
             name_of(a.surfaces, first[k].surface) == name_of(b.surfaces, second[k].surface);
    }
    crossings += static_cast<int>(first.size());
    different += same ? 0 : 1;
  }
  CHECK(crossings > least);
  CHECK(different == 0);
}

TEST_CASE("an evaluated scene comes back with the same surfaces", "[io][convert]") {
  const SceneFile scene = load_text("bracket.csg", bracket);
  const Converted out = converted(scene.scene);
  CHECK(out.warnings.empty());
  CHECK(out.file.warnings.empty());
  CHECK(is_closed(out.file.scene));
  CHECK(out.file.scene.surfaces.objects() == scene.scene.surfaces.objects());
  CHECK(out.file.scene.surfaces.primitives() == scene.scene.surfaces.primitives());
  CHECK(out.file.scene.surfaces.faces() == scene.scene.surfaces.faces());
  check_same_crossings(scene.scene, out.file.scene, 1e-4, 2000);
}

TEST_CASE("a converted scene is converted to itself", "[io][convert]") {
  const Converted once = converted(load_text("bracket.csg", bracket).scene);
  const Converted twice = converted(once.file.scene);
  CHECK((once.bytes == twice.bytes));
}

TEST_CASE("a converted scene may be placed and cut as an operand", "[io][convert]") {
  const SceneFile scene = load_text("bracket.csg", bracket);
  const TemporaryFile glb("bracket.glb", "");
  std::vector<std::string> warnings;
  write_glb(glb.path(), scene.scene, object_meshes(scene.scene, 1e-3), warnings);
  const SceneFile placed = load_text("whole.gltf", R"({"asset":{"version":"2.0"},
      "scenes":[{"nodes":[0,1]}],"nodes":[
      {"name":"copy","extras":{"asset":{"uri":"bracket.glb"}}},
      {"name":"cut","extras":{"csg":"difference"},"children":[2,3],"translation":[0,0,100]},
      {"name":"base","extras":{"asset":{"uri":"bracket.glb"}}},
      {"name":"knife","extras":{"shape":{"type":"box","size":[4,40,40]}}}]})");
  const SurfaceTable& surfaces = placed.scene.surfaces;
  CHECK(surfaces.objects() == scene.scene.surfaces.objects() + 1);
  const SurfaceTable& own = scene.scene.surfaces;
  for (std::uint32_t face = 0; face < own.faces(); ++face) {
    CHECK(surfaces.name(surfaces.primitive(SurfaceId{face})) ==
          "copy/" + own.name(own.primitive(SurfaceId{face})));
    CHECK(surfaces.face_in_primitive(SurfaceId{face}) == own.face_in_primitive(SurfaceId{face}));
  }
}

TEST_CASE("materials, lights, cameras and surroundings survive", "[io][convert]") {
  for (const std::string name : {"fig10", "fig8", "fig3", "fig9", "mesh_csg"}) {
    INFO(name);
    const SceneFile from = load_scene(std::string(RAYCAT_ASSETS) + "/scenes/" + name + ".gltf");
    const Converted to = converted(from.scene);
    const Scene& a = from.scene;
    const Scene& b = to.file.scene;
    REQUIRE(a.materials.size() == b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
      CHECK(a.materials[i].name == b.materials[i].name);
      CHECK(a.materials[i].emission == b.materials[i].emission);
      CHECK(a.materials[i].ambient == b.materials[i].ambient);
      CHECK(a.materials[i].diffuse == b.materials[i].diffuse);
      CHECK(a.materials[i].specular == b.materials[i].specular);
      CHECK(a.materials[i].shininess == b.materials[i].shininess);
      CHECK(a.materials[i].reflection == b.materials[i].reflection);
      CHECK(a.materials[i].transmission == b.materials[i].transmission);
      CHECK(a.materials[i].ior == b.materials[i].ior);
      CHECK(a.materials[i].single_sided == b.materials[i].single_sided);
    }
    REQUIRE(a.lights.size() == b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
      CHECK(a.lights[i].name == b.lights[i].name);
      CHECK(a.lights[i].kind == b.lights[i].kind);
      CHECK(glm::length(a.lights[i].position - b.lights[i].position) < 1e-9);
      CHECK(glm::length(a.lights[i].direction - b.lights[i].direction) < 1e-9);
      CHECK(a.lights[i].diffuse == b.lights[i].diffuse);
      CHECK(a.lights[i].specular == b.lights[i].specular);
      CHECK(a.lights[i].inverse_square == b.lights[i].inverse_square);
    }
    REQUIRE(a.cameras.size() == b.cameras.size());
    for (std::size_t i = 0; i < a.cameras.size(); ++i) {
      CHECK(a.cameras[i].name == b.cameras[i].name);
      CHECK(glm::length(a.cameras[i].eye - b.cameras[i].eye) < 1e-9);
      CHECK(glm::length(a.cameras[i].forward - b.cameras[i].forward) < 1e-9);
      CHECK(glm::length(a.cameras[i].up - b.cameras[i].up) < 1e-9);
      CHECK(a.cameras[i].half_height == Approx(b.cameras[i].half_height));
      CHECK(a.cameras[i].orthographic == b.cameras[i].orthographic);
    }
    CHECK(a.background == b.background);
    CHECK(a.ambient_light == b.ambient_light);
    CHECK(a.surfaces.faces() == b.surfaces.faces());
  }
}

TEST_CASE("a mesh that has no single side keeps both in a .glb", "[io][convert]") {
  const SceneFile sheet = load_text("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK_FALSE(sheet.scene.materials.at(0).single_sided);
  CHECK_FALSE(converted(sheet.scene).file.scene.materials.at(0).single_sided);
}

TEST_CASE("a .glb keeps the rules of glTF 2.0", "[io][convert]") {
  const std::string name = GENERATE("bracket.csg", "fig8.gltf", "fig9.gltf");
  const SceneFile scene = name == "bracket.csg"
                              ? load_text(name, bracket)
                              : load_scene(std::string(RAYCAT_ASSETS) + "/scenes/" + name);
  const std::string bytes = converted(scene.scene, 0.02).bytes;
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(word(4) == 2);
  CHECK(word(8) == bytes.size());
  CHECK(word(12) % 4 == 0);
  CHECK(bytes.substr(16, 4) == "JSON");
  const std::size_t binary = 20 + word(12);
  CHECK(word(binary) % 4 == 0);
  CHECK(bytes.substr(binary + 4, 4) == std::string("BIN\0", 4));
  CHECK(binary + 8 + word(binary) == bytes.size());
  const Json json = document(bytes);
  CHECK(json["asset"]["version"] == "2.0");
  CHECK(json["buffers"][0]["byteLength"] == word(binary));
  std::set<std::string> used;
  for (const auto& material : json["materials"]) {
    const Json extensions = material.value("extensions", Json::object());
    for (const auto& [extension, value] : extensions.items()) {
      used.insert(extension);
    }
  }
  if (json.contains("extensions")) {
    used.insert("KHR_lights_punctual");
  }
  const auto data = [&](const Json& accessor) {
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    return bytes.data() + binary + 8 + view["byteOffset"].get<std::size_t>();
  };
  for (const auto& mesh : json["meshes"]) {
    for (const auto& primitive : mesh["primitives"]) {
      used.insert("EXT_mesh_features");
      const Json& features = primitive["extensions"]["EXT_mesh_features"]["featureIds"][0];
      CHECK(features["featureCount"] == mesh["extras"]["raycat"]["features"].size());
      const auto accessor = [&](const Json& number) {
        return json["accessors"][number.get<std::size_t>()];
      };
      const Json positions = accessor(primitive["attributes"]["POSITION"]);
      const Json ids = accessor(primitive["attributes"]["_FEATURE_ID_0"]);
      const Json indices = accessor(primitive["indices"]);
      const std::size_t vertices = positions["count"];
      CHECK(ids["count"] == vertices);
      CHECK(indices["count"].get<std::size_t>() % 3 == 0);
      std::vector<float> least(3, 1e30f);
      std::vector<float> most(3, -1e30f);
      for (std::size_t i = 0; i < vertices * 3; ++i) {
        float value = 0.0f;
        std::memcpy(&value, data(positions) + 4 * i, 4);
        least[i % 3] = std::min(least[i % 3], value);
        most[i % 3] = std::max(most[i % 3], value);
      }
      CHECK(positions["min"].get<std::vector<float>>() == least);
      CHECK(positions["max"].get<std::vector<float>>() == most);
      // Each triangle is of one feature.
      int mixed = 0;
      for (std::size_t i = 0; i < indices["count"]; i += 3) {
        std::set<float> of;
        for (std::size_t k = 0; k < 3; ++k) {
          std::uint32_t index = 0;
          std::memcpy(&index, data(indices) + 4 * (i + k), 4);
          REQUIRE(index < vertices);
          float id = 0.0f;
          std::memcpy(&id, data(ids) + 4 * index, 4);
          CHECK((id >= 0.0f && id < features["featureCount"].get<float>()));
          of.insert(id);
        }
        mixed += of.size() == 1 ? 0 : 1;
      }
      CHECK(mixed == 0);
      const auto target = [&](const Json& of) {
        return json["bufferViews"][of["bufferView"].get<std::size_t>()]["target"];
      };
      CHECK(target(positions) == 34962);
      CHECK(target(ids) == 34962);
      CHECK(target(indices) == 34963);
    }
  }
  for (const auto& view : json["bufferViews"]) {
    CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
    CHECK(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>() <=
          word(binary));
  }
  CHECK(std::set<std::string>(json["extensionsUsed"].begin(), json["extensionsUsed"].end()) ==
        used);
}

TEST_CASE("what a .glb cannot keep is said", "[io][convert]") {
  const SceneFile endless = load_text("endless.gltf", R"({"asset":{"version":"2.0"},
      "scenes":[{"nodes":[0,1,2]}],"nodes":[
      {"name":"ground","extras":{"shape":{"type":"plane"}},"translation":[0,-1,0]},
      {"name":"ball","extras":{"shape":{"type":"sphere","radius":1}}},
      {"name":"wall","extras":{"csg":"difference"},"children":[3,4]},
      {"extras":{"shape":{"type":"plane"}}},
      {"extras":{"shape":{"type":"sphere"}}}]})");
  const Converted out = converted(endless.scene);
  CHECK(out.warnings ==
        std::vector<std::string>{"wall: is left out, since a half-space leaves it without end"});
  // The ground alone is a shape of ours.
  REQUIRE(out.file.scene.surfaces.objects() == 2);
  CHECK(out.file.scene.surfaces.name(ObjectId{0}) == "ground");
  CHECK(out.file.scene.solids.size() == 1);
}

}  // namespace
}  // namespace raycat
