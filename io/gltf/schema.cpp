#include "io/gltf/schema.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/json_fields.hpp"

namespace raycat {
namespace {

using nlohmann::json;

// Counts are of what tinygltf keeps in an int, and would narrow in silence.
enum class Kind { object, array, string, boolean, number, whole, count, index, numbers };

struct Rule {
  std::string_view path;  // steps between dots; [] is each element and * each member
  Kind kind;
  std::string_view target = "";  // what an index counts in
  std::size_t length = 0;        // of numbers
  bool required = false;
};

constexpr bool required = true;

// A container comes before what it contains.
constexpr auto rules = std::to_array<Rule>({
    {"asset", Kind::object, "", 0, required},
    {"asset.version", Kind::string, "", 0, required},
    {"asset.minVersion", Kind::string},
    {"extensionsUsed", Kind::array},
    {"extensionsUsed.[]", Kind::string},
    {"extensionsRequired", Kind::array},
    {"extensionsRequired.[]", Kind::string},
    {"extensions", Kind::object},
    {"extensions.KHR_lights_punctual", Kind::object},
    {"extensions.KHR_lights_punctual.lights", Kind::array, "", 0, required},
    {"extensions.KHR_lights_punctual.lights.[]", Kind::object},

    {"scene", Kind::index, "scenes"},
    {"scenes", Kind::array},
    {"scenes.[]", Kind::object},
    {"scenes.[].name", Kind::string},
    {"scenes.[].nodes", Kind::array},
    {"scenes.[].nodes.[]", Kind::index, "nodes"},

    {"nodes", Kind::array},
    {"nodes.[]", Kind::object},
    {"nodes.[].name", Kind::string},
    {"nodes.[].children", Kind::array},
    {"nodes.[].children.[]", Kind::index, "nodes"},
    {"nodes.[].mesh", Kind::index, "meshes"},
    {"nodes.[].camera", Kind::index, "cameras"},
    {"nodes.[].skin", Kind::index, "skins"},
    {"nodes.[].matrix", Kind::numbers, "", 16},
    {"nodes.[].translation", Kind::numbers, "", 3},
    {"nodes.[].rotation", Kind::numbers, "", 4},
    {"nodes.[].scale", Kind::numbers, "", 3},
    {"nodes.[].extensions", Kind::object},
    {"nodes.[].extensions.KHR_lights_punctual", Kind::object},
    {"nodes.[].extensions.KHR_lights_punctual.light", Kind::index,
     "extensions.KHR_lights_punctual.lights"},

    {"meshes", Kind::array},
    {"meshes.[]", Kind::object},
    {"meshes.[].name", Kind::string},
    {"meshes.[].primitives", Kind::array, "", 0, required},
    {"meshes.[].primitives.[]", Kind::object},
    {"meshes.[].primitives.[].attributes", Kind::object, "", 0, required},
    {"meshes.[].primitives.[].attributes.*", Kind::index, "accessors"},
    {"meshes.[].primitives.[].indices", Kind::index, "accessors"},
    {"meshes.[].primitives.[].material", Kind::index, "materials"},
    {"meshes.[].primitives.[].mode", Kind::count},
    {"meshes.[].primitives.[].targets", Kind::array},
    {"meshes.[].primitives.[].targets.[]", Kind::object},
    {"meshes.[].primitives.[].targets.[].*", Kind::index, "accessors"},
    {"meshes.[].primitives.[].extensions", Kind::object},

    {"accessors", Kind::array},
    {"accessors.[]", Kind::object},
    {"accessors.[].bufferView", Kind::index, "bufferViews"},
    {"accessors.[].byteOffset", Kind::whole},
    {"accessors.[].componentType", Kind::count, "", 0, required},
    {"accessors.[].count", Kind::whole, "", 0, required},
    {"accessors.[].type", Kind::string, "", 0, required},
    {"accessors.[].normalized", Kind::boolean},
    {"accessors.[].sparse", Kind::object},
    {"accessors.[].sparse.count", Kind::count, "", 0, required},
    {"accessors.[].sparse.indices", Kind::object, "", 0, required},
    {"accessors.[].sparse.indices.bufferView", Kind::index, "bufferViews", 0, required},
    {"accessors.[].sparse.indices.byteOffset", Kind::count},
    {"accessors.[].sparse.indices.componentType", Kind::count, "", 0, required},
    {"accessors.[].sparse.values", Kind::object, "", 0, required},
    {"accessors.[].sparse.values.bufferView", Kind::index, "bufferViews", 0, required},
    {"accessors.[].sparse.values.byteOffset", Kind::count},

    {"bufferViews", Kind::array},
    {"bufferViews.[]", Kind::object},
    {"bufferViews.[].buffer", Kind::index, "buffers", 0, required},
    {"bufferViews.[].byteOffset", Kind::whole},
    {"bufferViews.[].byteLength", Kind::whole, "", 0, required},
    {"bufferViews.[].byteStride", Kind::whole},
    {"buffers", Kind::array},
    {"buffers.[]", Kind::object},
    {"buffers.[].byteLength", Kind::whole, "", 0, required},
    {"buffers.[].uri", Kind::string},

    {"materials", Kind::array},
    {"materials.[]", Kind::object},
    {"materials.[].name", Kind::string},
    {"materials.[].pbrMetallicRoughness", Kind::object},
    {"materials.[].pbrMetallicRoughness.baseColorFactor", Kind::numbers, "", 4},
    {"materials.[].pbrMetallicRoughness.metallicFactor", Kind::number},
    {"materials.[].pbrMetallicRoughness.roughnessFactor", Kind::number},
    {"materials.[].pbrMetallicRoughness.baseColorTexture", Kind::object},
    {"materials.[].pbrMetallicRoughness.baseColorTexture.index", Kind::index, "textures", 0,
     required},
    {"materials.[].pbrMetallicRoughness.baseColorTexture.texCoord", Kind::whole},
    {"materials.[].pbrMetallicRoughness.baseColorTexture.extensions", Kind::object},
    {"materials.[].pbrMetallicRoughness.metallicRoughnessTexture", Kind::object},
    {"materials.[].pbrMetallicRoughness.metallicRoughnessTexture.index", Kind::index, "textures", 0,
     required},
    {"materials.[].normalTexture", Kind::object},
    {"materials.[].normalTexture.index", Kind::index, "textures", 0, required},
    {"materials.[].occlusionTexture", Kind::object},
    {"materials.[].occlusionTexture.index", Kind::index, "textures", 0, required},
    {"materials.[].emissiveTexture", Kind::object},
    {"materials.[].emissiveTexture.index", Kind::index, "textures", 0, required},
    {"materials.[].emissiveFactor", Kind::numbers, "", 3},
    {"materials.[].alphaMode", Kind::string},
    {"materials.[].alphaCutoff", Kind::number},
    {"materials.[].extensions", Kind::object},

    {"textures", Kind::array},
    {"textures.[]", Kind::object},
    {"textures.[].source", Kind::index, "images"},
    {"textures.[].sampler", Kind::index, "samplers"},
    {"images", Kind::array},
    {"images.[]", Kind::object},
    {"images.[].uri", Kind::string},
    {"images.[].bufferView", Kind::index, "bufferViews"},
    {"samplers", Kind::array},
    {"samplers.[]", Kind::object},
    {"samplers.[].magFilter", Kind::count},
    {"samplers.[].wrapS", Kind::count},
    {"samplers.[].wrapT", Kind::count},

    {"cameras", Kind::array},
    {"cameras.[]", Kind::object},
    {"cameras.[].name", Kind::string},
    {"cameras.[].type", Kind::string, "", 0, required},
    {"cameras.[].perspective", Kind::object},
    {"cameras.[].perspective.yfov", Kind::number, "", 0, required},
    {"cameras.[].perspective.znear", Kind::number, "", 0, required},
    {"cameras.[].orthographic", Kind::object},
    {"cameras.[].orthographic.xmag", Kind::number, "", 0, required},
    {"cameras.[].orthographic.ymag", Kind::number, "", 0, required},
    {"cameras.[].orthographic.zfar", Kind::number, "", 0, required},
    {"cameras.[].orthographic.znear", Kind::number, "", 0, required},
    {"skins", Kind::array},
    {"skins.[]", Kind::object},
    {"skins.[].joints", Kind::array, "", 0, required},
    {"skins.[].joints.[]", Kind::index, "nodes"},
});

std::vector<std::string_view> steps(std::string_view path) {
  std::vector<std::string_view> steps;
  while (!path.empty()) {
    const auto dot = path.find('.');
    steps.push_back(path.substr(0, dot));
    path.remove_prefix(dot == std::string_view::npos ? path.size() : dot + 1);
  }
  return steps;
}

class Checker {
 public:
  Checker(const std::filesystem::path& file, const json& gltf) : file_(file), gltf_(gltf) {}

  void check(const Rule& rule) {
    rule_ = &rule;
    steps_ = steps(rule.path);
    trail_.assign(steps_.size(), {});
    const json* target = rule.kind == Kind::index ? &gltf_ : nullptr;
    for (const auto step : target ? steps(rule.target) : std::vector<std::string_view>{}) {
      target = target && target->contains(step) ? &target->at(std::string(step)) : nullptr;
    }
    target_size_ = target ? target->size() : 0;
    descend(gltf_, 0);
  }

 private:
  // As deep as the rule's path has steps.
  void descend(const json& value, std::size_t step) {
    if (step == steps_.size()) {
      check_value(value);
    } else if (steps_[step] == "[]") {
      for (std::size_t i = 0; i < value.size(); ++i) {
        trail_[step] = {.index = i};
        descend(value[i], step + 1);
      }
    } else if (steps_[step] == "*") {
      for (const auto& [key, member] : value.items()) {
        trail_[step] = {.key = key};
        descend(member, step + 1);
      }
    } else {
      trail_[step] = {.key = steps_[step]};
      const auto member = value.find(steps_[step]);
      if (member != value.end()) {
        descend(*member, step + 1);
      } else if (rule_->required && step + 1 == steps_.size()) {
        fail("is missing");
      }
    }
  }

  void check_value(const json& value) const {
    switch (rule_->kind) {
      case Kind::object:
        return require(value.is_object(), value, "an object");
      case Kind::array:
        return require(value.is_array(), value, "an array");
      case Kind::string:
        return require(value.is_string(), value, "a string");
      case Kind::boolean:
        return require(value.is_boolean(), value, "true or false");
      case Kind::number:
        return require(value.is_number(), value, "a number");
      case Kind::whole:
        return require(is_whole(value), value, "a whole number from 0");
      case Kind::count:
        return require(is_whole(value) && value.get<std::uint64_t>() < std::uint64_t{1} << 31,
                       value, "a whole number from 0, below 2^31");
      case Kind::index:
        require(is_whole(value), value, "an index");
        if (value.get<std::uint64_t>() >= target_size_) {
          fail(fmt::format("there is no {}[{}]; the file has {}", rule_->target,
                           value.get<std::uint64_t>(), target_size_));
        }
        return;
      case Kind::numbers:
        return require(is_numbers(value), value, fmt::format("{} numbers", rule_->length));
    }
  }

  bool is_numbers(const json& value) const {
    return value.is_array() && value.size() == rule_->length &&
           std::all_of(value.begin(), value.end(),
                       [](const json& number) { return number.is_number(); });
  }

  void require(bool met, const json& value, std::string_view expected) const {
    if (!met) {
      fail(fmt::format("expected {}, but found {}", expected, excerpt(value.dump())));
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    std::string place;
    std::string property;
    for (std::size_t i = 0; i < trail_.size(); ++i) {
      const auto& [key, index] = trail_[i];
      if (i == 1 && steps_[i] == "[]") {
        place =
            steps_[0] == "nodes" ? node_place(gltf_, index) : fmt::format("{}[{}]", place, index);
      } else if (steps_[i] == "[]") {
        property += fmt::format("[{}]", index);
      } else if (i == 0) {
        place = key;
      } else {
        property += fmt::format("{}{}", property.empty() ? "" : ".", excerpt(key));
      }
    }
    throw LoadError(file_, place, property.empty() ? what : property + ": " + what);
  }

  struct Step {
    std::string_view key = {};
    std::size_t index = 0;
  };

  const std::filesystem::path& file_;
  const json& gltf_;
  const Rule* rule_ = nullptr;
  std::vector<std::string_view> steps_;
  std::vector<Step> trail_;
  std::size_t target_size_ = 0;
};

}  // namespace

std::string node_place(const json& gltf, std::size_t node) {
  const json& object = gltf.at("nodes").at(node);
  const auto name = object.is_object() ? object.find("name") : object.end();
  return name != object.end() && name->is_string()
             ? fmt::format("node {} '{}'", node, excerpt(name->get_ref<const std::string&>()))
             : fmt::format("node {}", node);
}

void check_schema(const std::filesystem::path& file, const json& gltf) {
  if (!gltf.is_object()) {
    throw LoadError(file, "JSON", "expected an object");
  }
  Checker checker(file, gltf);
  for (const Rule& rule : rules) {
    checker.check(rule);
  }
}

}  // namespace raycat
