#include "io/export/view_json.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>

#include "io/export/material_json.hpp"

namespace raycat {
namespace {

using Json = nlohmann::ordered_json;

// A node that stands at a place and looks along -Z, with +Y up.
Json placed_node(const std::string& name, const glm::dvec3& at, const glm::dvec3& right,
                 const glm::dvec3& up, const glm::dvec3& back) {
  return {{"name", name},
          {"matrix",
           {right.x, right.y, right.z, 0.0, up.x, up.y, up.z, 0.0, back.x, back.y, back.z, 0.0,
            at.x, at.y, at.z, 1.0}}};
}

void add_node(Json node, Json& document) {
  document["scenes"][0]["nodes"].push_back(document["nodes"].size());
  document["nodes"].push_back(std::move(node));
}

Json camera_json(const Camera& camera, double size) {
  const double far = 100.0 * size;
  const double near = 1e-3 * size;
  if (camera.orthographic) {
    return {{"type", "orthographic"},
            {"orthographic",
             {{"xmag", camera.half_height},
              {"ymag", camera.half_height},
              {"znear", near},
              {"zfar", far}}}};
  }
  return {{"type", "perspective"},
          {"perspective", {{"yfov", 2.0 * std::atan(camera.half_height)}, {"znear", near}}}};
}

// What a light without falloff does at the middle of the scene, one with it does too.
double intensity(const Light& light, float brightest, const glm::dvec3& middle) {
  const double strength = std::numbers::pi * static_cast<double>(brightest);
  if (light.inverse_square || light.kind == Light::Kind::directional) {
    return strength;
  }
  const glm::dvec3 way = light.position - middle;
  return strength * glm::dot(way, way);
}

Json light_json(const Light& light, const glm::dvec3& middle) {
  const float brightest = glm::compMax(light.diffuse);
  Json out{{"type", light.kind == Light::Kind::point         ? "point"
                    : light.kind == Light::Kind::directional ? "directional"
                                                             : "spot"},
           {"color", colour_json(brightest > 0.0f ? light.diffuse / brightest : light.diffuse)},
           {"intensity", intensity(light, brightest, middle)}};
  if (light.kind != Light::Kind::directional && std::isfinite(light.range)) {
    out["range"] = light.range;
  }
  if (light.kind == Light::Kind::spot) {
    out["spot"] = {{"innerConeAngle", light.inner_cone}, {"outerConeAngle", light.outer_cone}};
  }
  if (!light.inverse_square) {
    out["extras"]["whitted"] = {{"diffuse", colour_json(light.diffuse)},
                                {"specular", colour_json(light.specular)}};
  }
  return out;
}

}  // namespace

void add_view_json(const Scene& scene, Json& document) {
  const Bounds box = bounds(scene);
  const glm::dvec3 middle = box.empty() ? glm::dvec3(0.0) : box.center();
  const double size = box.empty() ? 1.0 : std::max(glm::length(box.half_size()), 1e-30);
  for (const Camera& camera : scene.cameras) {
    Json node = placed_node(camera.name, camera.eye, camera.right, camera.up, -camera.forward);
    node["camera"] = document["cameras"].size();
    document["cameras"].push_back(camera_json(camera, size));
    add_node(std::move(node), document);
  }
  for (const Light& light : scene.lights) {
    glm::dvec3 aside(0.0);
    aside[std::abs(light.direction.x) < 0.7 ? 0 : 1] = 1.0;
    const glm::dvec3 right = glm::normalize(glm::cross(aside, light.direction));
    Json node = placed_node(light.name, light.position, right, glm::cross(right, light.direction),
                            -light.direction);
    Json& lights = document["extensions"]["KHR_lights_punctual"]["lights"];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size();
    lights.push_back(light_json(light, middle));
    add_node(std::move(node), document);
  }
  document["scenes"][0]["extras"] = {{"background", colour_json(scene.background)},
                                     {"ambient_light", colour_json(scene.ambient_light)}};
}

}  // namespace raycat
