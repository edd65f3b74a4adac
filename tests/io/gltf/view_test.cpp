#include "io/gltf/view.hpp"

#include <numbers>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "io/load_scene.hpp"
#include "tests/io/gltf/text.hpp"

namespace raycat {
namespace {

// A quarter turn about +Y: what looked along -Z looks along -X.
const std::string turned = R"("rotation":[0,0.7071067811865476,0,0.7071067811865476])";

std::string lamp_text(const std::string& light, int times = 1) {
  std::string nodes;
  std::string roots;
  for (int i = 0; i < times; ++i) {
    const char* const comma = i > 0 ? "," : "";
    roots.append(comma).append(std::to_string(i));
    nodes.append(comma).append(R"({"name":"lamp","translation":[1,2,3],)").append(turned);
    nodes.append(R"(,"extensions":{"KHR_lights_punctual":{"light":0}}})");
  }
  return gltf(roots, nodes, R"(,"extensions":{"KHR_lights_punctual":{"lights":[)" + light + "]}}");
}

Light lamp(const std::string& light, double exposure = 0.0) {
  const TemporaryFile file("scene.gltf", lamp_text(light));
  return load_scene(file.path(), {.exposure = exposure}).scene.lights.at(0);
}

Camera camera(const std::string& node, const std::string& projection) {
  return load_text("scene.gltf",
                   gltf("0", R"({"camera":0)" + node + "}", R"(,"cameras":[)" + projection + "]"))
      .scene.cameras.at(0);
}

const std::string perspective =
    R"({"type":"perspective","perspective":{"yfov":1.5707963267948966,"znear":0.1}})";

TEST_CASE("a punctual light gives its intensity over pi, twice as much for each EV", "[io][gltf]") {
  const std::string point = R"({"type":"point","color":[1,0.5,0],"intensity":6.283185307179586})";
  const Light light = lamp(point);
  CHECK(light.kind == Light::Kind::point);
  CHECK(light.name == "lamp");
  CHECK(light.position == glm::dvec3(1, 2, 3));
  CHECK(light.inverse_square);
  CHECK(std::isinf(light.range));
  CHECK(light.diffuse.r == Approx(2.0));
  CHECK(light.diffuse.g == Approx(1.0));
  CHECK(light.diffuse.b == 0.0f);
  CHECK(light.specular == light.diffuse);
  CHECK(lamp(point, 1.0).diffuse.r == Approx(4.0));
  CHECK(lamp(point, -2.0).diffuse.r == Approx(0.5));
}

TEST_CASE("a directional light shines along its node's -Z and does not fall off", "[io][gltf]") {
  const Light light = lamp(R"({"type":"directional"})");
  CHECK(light.kind == Light::Kind::directional);
  CHECK(glm::distance(light.direction, glm::dvec3(-1, 0, 0)) < 1e-12);
  CHECK_FALSE(light.inverse_square);
  CHECK(light.diffuse.r == Approx(1.0 / std::numbers::pi));
}

TEST_CASE("a spot has its cones and range", "[io][gltf]") {
  const Light light =
      lamp(R"({"type":"spot","range":5,"spot":{"innerConeAngle":0.25,"outerConeAngle":0.5}})");
  CHECK(light.kind == Light::Kind::spot);
  CHECK(light.inner_cone == 0.25);
  CHECK(light.outer_cone == 0.5);
  CHECK(light.range == 5.0);
  CHECK(light.inverse_square);
  const Light plain = lamp(R"({"type":"spot","spot":{}})");
  CHECK(plain.inner_cone == 0.0);
  CHECK(plain.outer_cone == Approx(std::numbers::pi / 4));
}

TEST_CASE("a whitted light has the colours of its extras, whatever the exposure", "[io][gltf]") {
  const Light light = lamp(
      R"({"type":"point","intensity":100,"extras":{"whitted":{"specular":[0.5,0.5,0]}}})", 3.0);
  CHECK(light.diffuse == glm::vec3(1.0f));
  CHECK(light.specular == glm::vec3(0.5f, 0.5f, 0.0f));
  CHECK_FALSE(light.inverse_square);
}

TEST_CASE("a light that means nothing is refused", "[io][gltf]") {
  const auto error = [](const std::string& light) { return gltf_error(lamp_text(light)); };
  CHECK(error(R"({"type":"area"})") ==
        "lights[0]: unknown type 'area'; expected point, directional or spot");
  CHECK(error(R"({"type":"point","intensity":-1})") == "lights[0]: intensity must not be negative");
  CHECK(error(R"({"type":"point","color":[0,0,-1]})") == "lights[0]: color must not be negative");
  CHECK(error(R"({"type":"point","range":0})") == "lights[0]: range must be above 0");
  CHECK(error(R"({"type":"spot","spot":{"innerConeAngle":1,"outerConeAngle":0.5}})") ==
        "lights[0]: the cone angles must be 0 <= inner <= outer <= pi/2");
  CHECK(error(R"({"type":"point","extras":{"whitted":{"color":[1,1,1]}}})") ==
        "lights[0]: extras.whitted: unknown key 'color'; expected diffuse, specular");
}

TEST_CASE("64 lights are read and 65 are refused", "[io][gltf]") {
  const std::string point = R"({"type":"point"})";
  CHECK(load_text("scene.gltf", lamp_text(point, 64)).scene.lights.size() == 64);
  CHECK(gltf_error(lamp_text(point, 65)) ==
        "lights: at most 64 lights are supported, but there are 65");
}

TEST_CASE("a camera looks along its node's -Z", "[io][gltf]") {
  const Camera is =
      camera(R"(,"name":"eye","translation":[1,2,3],"scale":[2,3,4],)" + turned, perspective);
  CHECK(is.name == "eye");
  CHECK_FALSE(is.orthographic);
  CHECK(is.half_height == Approx(1.0));  // tan(45 degrees)
  CHECK(is.eye == glm::dvec3(1, 2, 3));
  CHECK(glm::distance(is.forward, glm::dvec3(-1, 0, 0)) < 1e-12);
  CHECK(glm::distance(is.up, glm::dvec3(0, 1, 0)) < 1e-12);
  CHECK(glm::distance(is.right, glm::dvec3(0, 0, -1)) < 1e-12);
}

TEST_CASE("look_at poses a camera in place of its node", "[io][gltf]") {
  const Camera is = camera(R"(,"translation":[7,7,7],"extras":{"look_at":{
      "eye":[0,5,0],"target":[0,0,0],"up":[0,0,-1]}})",
                           perspective);
  CHECK(is.eye == glm::dvec3(0, 5, 0));
  CHECK(glm::distance(is.forward, glm::dvec3(0, -1, 0)) < 1e-12);
  CHECK(glm::distance(is.up, glm::dvec3(0, 0, -1)) < 1e-12);
}

TEST_CASE("an orthographic camera sees ymag up and down", "[io][gltf]") {
  const auto ortho = [](const std::string& ymag) {
    return R"({"name":"plan","type":"orthographic","orthographic":{"xmag":1,"ymag":)" + ymag +
           R"(,"znear":0,"zfar":9}})";
  };
  const Camera is = camera("", ortho("3"));
  CHECK(is.orthographic);
  CHECK(is.name == "plan");
  CHECK(is.half_height == 3.0);
  const auto flat =
      load_text("scene.gltf", gltf("0", R"({"camera":0})", R"(,"cameras":[)" + ortho("0") + "]"));
  CHECK(flat.scene.cameras.empty());
  REQUIRE(flat.warnings.size() == 1);
  CHECK(flat.warnings[0] == "node 0: the camera's view has no height and is left out");
}

TEST_CASE("look_at without a camera or a target is refused", "[io][gltf]") {
  const auto error = [](const std::string& node) {
    return gltf_error(gltf("0", "{" + node + "}", R"(,"cameras":[)" + perspective + "]"));
  };
  CHECK(error(R"("extras":{"look_at":{"eye":[0,0,1],"target":[0,0,0]}})") ==
        "node 0: extras.look_at: the node has no camera");
  CHECK(error(R"("camera":0,"extras":{"look_at":{"eye":[0,0,1]}})") ==
        "node 0: extras.look_at: target is missing");
}

}  // namespace
}  // namespace raycat
