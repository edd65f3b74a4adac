#include <catch2/catch.hpp>

#include "geometry/shape.hpp"
#include "io/scene/closed_scene.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

SceneFile load(const std::string& document) { return load_text("scene.gltf", document); }

std::string ball_error(const std::string& extras) {
  return gltf_error(gltf("0", R"({"name":"ball","extras":)" + extras + "}"));
}

const std::string sphere = R"({"extras":{"shape":{"type":"sphere"}}})";

TEST_CASE("a lone shape is an object named for its node", "[io][gltf]") {
  const auto file = load(gltf("0", R"({"name":"ball","translation":[1,2,3],
                         "extras":{"shape":{"type":"sphere","radius":2}}})"));
  REQUIRE(file.scene.solids.size() == 1);
  CHECK(file.scene.surfaces.objects() == 1);
  CHECK(file.scene.surfaces.name(ObjectId{0}) == "ball");
  CHECK(file.scene.surfaces.name(PrimitiveId{0}) == "ball");
  CHECK(file.scene.solids[0].solid.bounds() == Bounds{.min = {-1, 0, 1}, .max = {3, 4, 5}});
  CHECK(file.csg_nodes == 0);
  CHECK(is_closed(file.scene));
}

TEST_CASE("every shape has the faces that docs/scene-files.md lists", "[io][gltf]") {
  const auto [shape, faces] = GENERATE(table<std::string, std::size_t>(
      {{R"({"type":"sphere"})", 1},
       {R"({"type":"box","size":[1,2,3]})", 6},
       {R"({"type":"cylinder","height":2,"radiusTop":1,"radiusBottom":1})", 3},
       {R"({"type":"cylinder","height":2,"radiusTop":0,"radiusBottom":1})", 2},
       {R"({"type":"capsule"})", 1},
       {R"({"type":"plane"})", 1},
       {R"({"type":"torus","radius":1,"tube":0.25})", 1},
       {R"({"type":"polyhedron","points":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],
            "faces":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]})",
        4}}));
  CHECK(load(gltf("0", R"({"extras":{"shape":)" + shape + "}}")).scene.surfaces.faces() == faces);
}

TEST_CASE("a csg node is one object and its leaves are primitives", "[io][gltf]") {
  const auto file = load(gltf("0", R"({"name":"cut","extras":{"csg":"difference"},"children":[1,2]},
      {"name":"block","extras":{"shape":{"type":"box"},"material":1}},
      {"name":"group","translation":[0,1,0],"children":[3,4]},
      {"name":"ball","extras":{"shape":{"type":"sphere"}}},
      {"name":"ball","extras":{"shape":{"type":"sphere"},"material":0}})",
                              R"(,"materials":[{},{}])"));
  REQUIRE(file.scene.solids.size() == 1);
  const auto& solid = file.scene.solids[0];
  CHECK(file.scene.surfaces.objects() == 1);
  CHECK(file.scene.surfaces.primitives() == 3);
  CHECK(file.scene.surfaces.name(PrimitiveId{2}) == "ball (2)");
  CHECK(solid.solid.tree().nodes().size() == 5);
  CHECK(solid.solid.tree().nodes()[4].operation == Operation::difference);
  CHECK(solid.solid.tree().nodes()[3].operation == Operation::set_union);
  CHECK(solid.solid.tree().nodes()[3].subtracted);
  CHECK(file.csg_nodes == 5);
  CHECK(solid.materials == std::vector{MaterialId{1}, MaterialId{2}, MaterialId{0}});
}

TEST_CASE("cut_material base gives cut surfaces the first operand's material", "[io][gltf]") {
  const std::string nodes = R"({"extras":{"csg":"difference","cut_material":"base"},
       "children":[1,2]},{"extras":{"shape":{"type":"box"},"material":1}},
      {"extras":{"shape":{"type":"sphere"},"material":0}})";
  const auto file = load(gltf("0", nodes, R"(,"materials":[{},{}])"));
  CHECK(file.scene.solids[0].materials == std::vector{MaterialId{1}, MaterialId{1}});
}

TEST_CASE("whitted extras are the material's constants", "[io][gltf]") {
  const auto file = load(gltf("0", sphere, R"(,"materials":[{"extras":{"whitted":{
      "diffuse":[0.1,0.2,0.3],"shininess":40,"reflection":0.5,"transmission":[0,0.5,1],
      "ior":1.5}}}])"));
  const Material& material = file.scene.materials[0];
  CHECK(material.diffuse == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(material.shininess == 40.0f);
  CHECK(material.reflection == glm::vec3(0.5f));
  CHECK(material.transmission == glm::vec3(0.0f, 0.5f, 1.0f));
  CHECK(material.ior == 1.5f);
  CHECK_FALSE(material.fresnel);
}

TEST_CASE("look_at, background and lights of extras are read", "[io][gltf]") {
  const auto file = load(R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0,1],"extras":{"background":[0,0.5,1],"ambient_light":[0.1,0.1,0.1]}}],
    "nodes":[{"name":"eye","camera":0,"extras":{"look_at":{"eye":[0,0,6],"target":[0,0,0]}}},
             {"name":"lamp","translation":[1,2,3],
              "extensions":{"KHR_lights_punctual":{"light":0}}}],
    "cameras":[{"type":"perspective","perspective":{"yfov":1.5707963267948966,"znear":0.1}}],
    "extensionsUsed":["KHR_lights_punctual"],
    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point",
      "extras":{"whitted":{"diffuse":[1,0.5,0.25]}}}]}}})");
  CHECK(file.scene.background == glm::vec3(0.0f, 0.5f, 1.0f));
  CHECK(file.scene.ambient_light == glm::vec3(0.1f));
  REQUIRE(file.scene.cameras.size() == 1);
  CHECK(file.scene.cameras[0].name == "eye");
  CHECK(file.scene.cameras[0].eye == glm::dvec3(0, 0, 6));
  CHECK(file.scene.cameras[0].half_height == Approx(1.0));
  REQUIRE(file.scene.lights.size() == 1);
  CHECK(file.scene.lights[0].position == glm::dvec3(1, 2, 3));
  CHECK(file.scene.lights[0].diffuse == glm::vec3(1.0f, 0.5f, 0.25f));
  CHECK(file.scene.lights[0].specular == glm::vec3(1.0f));
  CHECK_FALSE(file.scene.lights[0].inverse_square);
  CHECK(file.extensions == std::vector<std::string>{"KHR_lights_punctual"});
}

TEST_CASE("a mistake in our extras is named", "[io][gltf]") {
  CHECK(ball_error(R"({"shape":{"type":"sphere","raduis":1}})") ==
        "node 0 'ball': extras.shape: unknown key 'raduis'; expected radius");
  CHECK(ball_error(R"({"shape":{"type":"plane","size":1}})") ==
        "node 0 'ball': extras.shape: unknown key 'size'; expected none");
  CHECK(ball_error(R"({"shape":{"type":"ball"}})") ==
        "node 0 'ball': extras.shape: unknown type 'ball'; expected sphere, box, cylinder, "
        "capsule, plane, torus or polyhedron");
  CHECK(ball_error(R"({"shape":{"radius":1}})") == "node 0 'ball': extras.shape: type is missing");
  CHECK(ball_error(R"({"shape":{"type":"sphere","radius":"1"}})") ==
        "node 0 'ball': extras.shape: radius: expected a number, but found \"1\"");
  CHECK(ball_error(R"({"shape":{"type":"sphere","radius":-1}})") ==
        "node 0 'ball': extras.shape: radius must be a finite number above 0, but is -1");
  CHECK(ball_error(R"({"shape":{"type":"box","size":[1,2]}})") ==
        "node 0 'ball': extras.shape: size: expected 3 numbers, but found [1,2]");
  CHECK(ball_error(R"({"shape":7})") ==
        "node 0 'ball': extras.shape: expected an object, but found 7");
  CHECK(ball_error(R"({"shape":{"type":"sphere"},"material":3})") ==
        "node 0 'ball': extras: material: there is no materials[3]; the file has 0");
  CHECK(ball_error(R"({"csg":"unoin"})") ==
        "node 0 'ball': extras: csg: unknown operation 'unoin'; expected union, intersection or "
        "difference");
  CHECK(ball_error(R"({"csg":"union"})") == "node 0 'ball': extras.csg: has no operands below it");
  CHECK(ball_error(R"({"csg":"union","shape":{"type":"sphere"}})") ==
        "node 0 'ball': extras: a node has only one of csg, shape and asset");
  CHECK(ball_error(R"({"asset":{"uri":"../part.glb"}})") ==
        "node 0 'ball': extras.asset: URI '../part.glb' leads out of the file's folder");
  CHECK(gltf_error(gltf("0", R"({"extras":{"csg":"union"},"children":[1]},{"name":"empty"})")) ==
        "node 1 'empty': a CSG operand must be a shape, a mesh or a csg node");
  CHECK(gltf_error(
            gltf("0", sphere, R"(,"materials":[{"name":"m","extras":{"whitted":{"kd":1}}}])")) ==
        "materials[0] 'm': extras.whitted: unknown key 'kd'; expected emission, ambient, diffuse, "
        "specular, shininess, reflection, transmission, ior");
}

TEST_CASE("extras of others are left alone", "[io][gltf]") {
  CHECK_NOTHROW(load(gltf("0", R"({"extras":{"material":"oak","cycles":{"a":1}}})")));
  CHECK_NOTHROW(load(gltf("0", R"({"extras":"text"})")));
}

TEST_CASE("an asset places the objects of another file", "[io][gltf]") {
  const TemporaryFile part("part.gltf",
                           gltf("0,1", R"({"name":"a","extras":{"shape":{"type":"sphere"}}},
                                          {"name":"b","extras":{"shape":{"type":"box"}}})"));
  const auto file = load(gltf("0,1", R"({"name":"both","extras":{"asset":{"uri":"part.gltf"}}},
                     {"name":"cut","extras":{"csg":"difference"},"children":[2,3]},
                     {"name":"one","extras":{"asset":{"uri":"part.gltf","node":"b"}}},
                     {"extras":{"shape":{"type":"sphere"}}})"));
  CHECK(file.scene.solids.size() == 3);
  CHECK(file.scene.surfaces.objects() == 3);
  CHECK(file.scene.surfaces.name(ObjectId{1}) == "both/b");
  CHECK(file.scene.surfaces.name(PrimitiveId{2}) == "one/b");
  CHECK(gltf_error(gltf("0", R"({"extras":{"asset":{"uri":"scene.gltf"}}})")) ==
        "node 0: extras.asset: 'scene.gltf' places itself");
}

TEST_CASE("a tree of csg nodes may be as deep as it likes", "[io][gltf]") {
  constexpr int depth = 20000;
  std::string nodes;
  for (int i = 0; i < depth; ++i) {
    nodes += R"({"extras":{"csg":"union"},"children":[)" + std::to_string(i + 1) + "]},";
  }
  const auto file = load(gltf("0", nodes + sphere));
  CHECK(file.csg_nodes == depth + 1);
}

}  // namespace
}  // namespace raycat
