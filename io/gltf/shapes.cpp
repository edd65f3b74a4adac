#include "io/gltf/shapes.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat {
namespace {

struct Physics {
  const char* bodies;
  const char* shapes;
  RoundDefaults defaults;
};

const auto kinds = std::to_array<Physics>(
    {{.bodies = "KHR_physics_rigid_bodies", .shapes = "KHR_implicit_shapes", .defaults = {}},
     {.bodies = "OMI_physics_body",
      .shapes = "OMI_physics_shape",
      .defaults = {.cylinder_height = 2.0, .capsule_height = 1.0, .radius = 0.5}}});

// The number of the shape in the document's list; nothing if the collider has none of these.
std::optional<std::uint64_t> shape_number(JsonFields& collider) {
  auto geometry = collider.object("geometry");
  return geometry ? geometry->whole("shape") : collider.whole("shape");
}

std::optional<Shape> listed_shape(const GltfDocument& document, const Physics& physics,
                                  std::uint64_t number) {
  const nlohmann::json none = nlohmann::json::object();
  JsonFields root(document.file, "glTF", "", document.json);
  auto extensions = root.object("extensions");
  auto list = extensions ? extensions->object(physics.shapes) : std::nullopt;
  const nlohmann::json* shapes = list ? list->array("shapes") : nullptr;
  const std::size_t size = shapes == nullptr ? 0 : shapes->size();
  if (number >= size) {
    throw LoadError(document.file, physics.shapes,
                    fmt::format("there is no shapes[{}]; the file has {}", number, size));
  }
  const std::string place = fmt::format("{}: shapes[{}]", physics.shapes, number);
  JsonFields fields(document.file, place, "", (*shapes)[number]);
  const std::string type = fields.type();
  auto own = fields.object(type);
  JsonFields parameters = own ? *own : JsonFields(document.file, place, "", none);
  if (type == "plane" && (parameters.number("sizeX") || parameters.number("sizeZ"))) {
    return std::nullopt;
  }
  return implicit_shape(type, parameters, physics.defaults);
}

}  // namespace

std::optional<Shape> implicit_shape(const std::string& type, JsonFields& fields,
                                    const RoundDefaults& defaults) {
  const auto radius = [&](const char* key) { return fields.number(key).value_or(defaults.radius); };
  std::optional<Shape> shape;
  if (type == "sphere") {
    shape = Sphere{.radius = fields.number("radius").value_or(0.5)};
  } else if (type == "box") {
    shape = Box{.size = fields.vector("size").value_or(glm::dvec3(1.0))};
  } else if (type == "cylinder") {
    shape = Cylinder{.height = fields.number("height").value_or(defaults.cylinder_height),
                     .radius_top = radius("radiusTop"),
                     .radius_bottom = radius("radiusBottom")};
  } else if (type == "capsule") {
    shape = Capsule{.height = fields.number("height").value_or(defaults.capsule_height),
                    .radius_top = radius("radiusTop"),
                    .radius_bottom = radius("radiusBottom")};
  } else if (type == "plane") {
    shape = HalfSpace{};
  }
  try {
    if (shape) {
      validate(*shape);
    }
  } catch (const std::invalid_argument& error) {
    fields.fail(error.what());
  }
  return shape;
}

GltfColliders::GltfColliders(const GltfDocument& document)
    : document_(document),
      below_(document.model.nodes.size()),
      above_(document.model.nodes.size()) {
  const auto& nodes = document.model.nodes;
  std::vector<std::size_t> pending;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].mesh >= 0) {
      for (std::optional<std::size_t> at = i; at && !below_[*at]; at = document.parents[*at]) {
        below_[*at] = true;
      }
    }
    if (!document.parents[i]) {
      pending.push_back(i);
    }
  }
  while (!pending.empty()) {
    const std::size_t node = pending.back();
    pending.pop_back();
    for (const int number : nodes[node].children) {
      const auto child = static_cast<std::size_t>(number);
      above_[child] = above_[node] || nodes[node].mesh >= 0;
      pending.push_back(child);
    }
  }
}

bool GltfColliders::at(std::size_t node) const {
  const auto& json = document_.json["nodes"][node];
  return std::ranges::any_of(kinds, [&](const Physics& physics) {
    auto body = document_.extension(json, physics.bodies, document_.node_place(node));
    return body && body->object("collider");
  });
}

std::optional<Shape> GltfColliders::shown(std::size_t node) const {
  if (above_[node] || below_[document_.parents[node].value_or(node)]) {
    return std::nullopt;
  }
  for (const Physics& physics : kinds) {
    auto body = document_.extension(document_.json["nodes"][node], physics.bodies,
                                    document_.node_place(node));
    auto collider = body ? body->object("collider") : std::nullopt;
    const auto number = collider ? shape_number(*collider) : std::nullopt;
    if (number) {
      return listed_shape(document_, physics, *number);
    }
  }
  return std::nullopt;
}

}  // namespace raycat
