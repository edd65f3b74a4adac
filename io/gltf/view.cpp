#include "io/gltf/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/extras.hpp"

namespace raycat {
namespace {

constexpr std::size_t max_lights = 64;  // as a ray tree counts them
constexpr double pi = std::numbers::pi;
constexpr std::size_t max_index =
    std::numeric_limits<std::size_t>::max();  // the schema has checked

std::string camera_name(const GltfDocument& document, std::size_t node) {
  const std::string& own = document.model.nodes[node].name;
  const auto camera = static_cast<std::size_t>(document.model.nodes[node].camera);
  const std::string& shared = document.model.cameras[camera].name;
  return !own.empty() ? own : !shared.empty() ? shared : fmt::format("camera {}", camera);
}

// Half the height of the view, or 0 where the file gives none that makes sense.
double half_height(const tinygltf::Camera& camera) {
  if (camera.type == "orthographic") {
    return std::max(camera.orthographic.ymag, 0.0);
  }
  const double yfov = camera.perspective.yfov;
  return yfov > 0.0 && yfov < pi ? std::tan(yfov / 2.0) : 0.0;
}

// The node may scale and shear; only where it looks and what is upright there count.
Camera pose(const glm::dmat4& world) {
  const glm::dvec3 eye(world[3]);
  const glm::dvec3 back(world[2]);
  return look_at(eye, eye - back / glm::length(back), glm::dvec3(world[1]));
}

void require(const JsonFields& fields, bool met, const std::string& what) {
  if (!met) {
    fields.fail(what);
  }
}

glm::dvec3 colour(const JsonFields& fields, const char* name, const glm::dvec3& value) {
  require(fields, value.x >= 0.0 && value.y >= 0.0 && value.z >= 0.0,
          fmt::format("{} must not be negative", name));
  return value;
}

void read_cone(JsonFields& fields, Light& light) {
  auto spot = fields.object("spot");
  light.outer_cone = spot ? spot->number("outerConeAngle").value_or(pi / 4.0) : pi / 4.0;
  light.inner_cone = spot ? spot->number("innerConeAngle").value_or(0.0) : 0.0;
  require(fields,
          light.inner_cone >= 0.0 && light.inner_cone <= light.outer_cone &&
              light.outer_cone > 0.0 && light.outer_cone <= pi / 2.0,
          "the cone angles must be 0 <= inner <= outer <= pi/2");
}

Light::Kind light_kind(JsonFields& fields) {
  const std::string type = fields.type();
  if (type == "point") {
    return Light::Kind::point;
  }
  if (type == "directional") {
    return Light::Kind::directional;
  }
  if (type == "spot") {
    return Light::Kind::spot;
  }
  fields.fail(fmt::format("unknown type '{}'; expected point, directional or spot", excerpt(type)));
}

Light read_light(const GltfDocument& document, std::size_t number, double exposure) {
  const auto& json = document.json["extensions"]["KHR_lights_punctual"]["lights"][number];
  JsonFields fields(document.file, fmt::format("lights[{}]", number), "", json);
  Light light;
  light.kind = light_kind(fields);
  if (light.kind == Light::Kind::spot) {
    read_cone(fields, light);
  }
  if (const auto range = fields.number("range")) {
    require(fields, *range > 0.0, "range must be above 0");
    light.range = *range;
  }
  if (const auto extras = json.find("extras"); extras != json.end() && extras->is_object()) {
    JsonFields ours(document.file, fmt::format("lights[{}]", number), "extras", *extras);
    if (auto whitted = ours.object("whitted")) {
      const glm::dvec3 white(1.0);
      light.diffuse = colour(*whitted, "diffuse", whitted->vector("diffuse").value_or(white));
      light.specular = colour(*whitted, "specular", whitted->vector("specular").value_or(white));
      whitted->refuse_others();
      ours.refuse_others();
      return light;
    }
  }
  const double intensity = fields.number("intensity").value_or(1.0);
  require(fields, intensity >= 0.0, "intensity must not be negative");
  const glm::dvec3 tint = colour(fields, "color", fields.vector("color").value_or(glm::dvec3(1.0)));
  light.diffuse = glm::vec3(tint * (intensity / pi * std::exp2(exposure)));
  light.specular = light.diffuse;
  light.inverse_square = light.kind != Light::Kind::directional;
  return light;
}

}  // namespace

std::vector<Camera> read_cameras(GltfDocument& document, const GltfNodes& nodes) {
  std::vector<Camera> cameras;
  for (const std::size_t node : nodes.order) {
    if (document.model.nodes[node].camera < 0) {
      continue;
    }
    const auto& from =
        document.model.cameras[static_cast<std::size_t>(document.model.nodes[node].camera)];
    const double height = half_height(from);
    if (!(height > 0.0) || !std::isfinite(height)) {
      document.warnings.push_back(fmt::format("{}: the camera's view has no height and is left out",
                                              document.node_place(node)));
      continue;
    }
    try {
      const auto extras = node_extras(document, node);
      Camera camera = extras.look_at ? *extras.look_at : pose(nodes.world[node]);
      camera.name = camera_name(document, node);
      camera.orthographic = from.type == "orthographic";
      camera.half_height = height;
      cameras.push_back(std::move(camera));
    } catch (const std::invalid_argument& error) {
      throw LoadError(document.file, document.node_place(node), error.what());
    }
  }
  return cameras;
}

std::vector<Light> read_lights(const GltfDocument& document, const GltfNodes& nodes,
                               double exposure) {
  std::vector<Light> lights;
  for (const std::size_t node : nodes.order) {
    if (nodes.hidden[node]) {
      continue;
    }
    const auto& json = document.json["nodes"][node];
    auto extension = document.extension(json, "KHR_lights_punctual", document.node_place(node));
    const auto number = extension ? extension->index("light", "lights", max_index) : std::nullopt;
    if (!number) {
      continue;
    }
    Light light = read_light(document, *number, exposure);
    const glm::dmat4& world = nodes.world[node];
    const glm::dvec3 axis(-world[2]);
    const double length = glm::length(axis);
    if (light.kind != Light::Kind::point && !(length > 0.0 && std::isfinite(length))) {
      throw LoadError(document.file, document.node_place(node),
                      "the transform leaves the light no direction");
    }
    light.direction = light.kind == Light::Kind::point ? light.direction : axis / length;
    light.position = glm::dvec3(world[3]);
    light.name = document.node_name(node);
    lights.push_back(std::move(light));
  }
  if (lights.size() > max_lights) {
    throw LoadError(document.file, "lights",
                    fmt::format("at most {} lights are supported, but there are {}", max_lights,
                                lights.size()));
  }
  return lights;
}

void read_surroundings(const GltfDocument& document, Scene& scene) {
  const auto scenes = document.json.find("scenes");
  if (scenes == document.json.end() || scenes->empty()) {
    return;
  }
  const auto number = document.json.value("scene", std::size_t{0});
  const auto extras = scenes->at(number).find("extras");
  if (extras == scenes->at(number).end() || !extras->is_object()) {
    return;
  }
  JsonFields fields(document.file, fmt::format("scenes[{}]", number), "extras", *extras);
  bool ours = false;
  for (const auto& [key, to] : {std::pair("background", &scene.background),
                                std::pair("ambient_light", &scene.ambient_light)}) {
    if (const auto value = fields.vector(key)) {
      *to = glm::vec3(colour(fields, key, *value));
      ours = true;
    }
  }
  if (ours) {
    fields.refuse_others();
  }
}

}  // namespace raycat
