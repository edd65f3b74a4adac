#include "io/gltf_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "io/gltf_accessor.hpp"
#include "io/scene_file.hpp"

namespace raycat {
namespace {

using nlohmann::json;

constexpr std::uint64_t most = std::uint64_t{1} << 27;  // faces of a scene

class NamesReader {
 public:
  NamesReader(const GltfDocument& document, std::size_t mesh)
      : document_(document), place_(fmt::format("meshes[{}]", mesh)) {}

  FeatureNames read(const json& table) const {
    FeatureNames out;
    std::vector<std::uint64_t> starts{0};
    for (const json& primitive : array(table, "primitives")) {
      const bool fits = primitive.is_object() && primitive.contains("name") &&
                        primitive["name"].is_string() && primitive.contains("faces") &&
                        whole(primitive["faces"], most);
      if (!fits) {
        fail("primitives: each needs a name and a number of faces");
      }
      out.primitives.push_back(
          {.name = primitive["name"], .faces = primitive["faces"].get<std::uint32_t>()});
      starts.push_back(starts.back() + out.primitives.back().faces);
      if (starts.back() > most) {
        fail(fmt::format("primitives: at most {} faces are read", most));
      }
    }
    for (const json& feature : array(table, "features")) {
      if (!feature.is_array() || feature.size() != 2 || !whole(feature[0], out.primitives.size()) ||
          !whole(feature[1], out.primitives[feature[0]].faces)) {
        fail(fmt::format("features: number {} is not of a face of a primitive", out.faces.size()));
      }
      out.faces.push_back(
          static_cast<std::uint32_t>(starts[feature[0]] + feature[1].get<std::uint64_t>()));
    }
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw LoadError(document_.file, place_, "extras.raycat: " + what);
  }

  const json& array(const json& table, const char* key) const {
    const auto found = table.find(key);
    if (found == table.end() || !found->is_array()) {
      fail(fmt::format("{}: expected an array", key));
    }
    return *found;
  }

  // Is the value a whole number from 0 to below `end`?
  static bool whole(const json& value, std::uint64_t end) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() < end;
  }

  const GltfDocument& document_;
  std::string place_;
};

std::optional<std::uint32_t> id(const json& set, const char* key) {
  const auto found = set.find(key);
  if (found == set.end() || !found->is_number_unsigned() ||
      found->get<std::uint64_t>() >= std::numeric_limits<std::uint32_t>::max()) {
    return std::nullopt;
  }
  return found->get<std::uint32_t>();
}

}  // namespace

std::optional<FeatureNames> feature_names(const GltfDocument& document, std::size_t mesh) {
  const json& from = document.json["meshes"][mesh];
  const auto extras = from.find("extras");
  if (extras == from.end() || !extras->is_object()) {
    return std::nullopt;
  }
  const auto table = extras->find("raycat");
  if (table == extras->end() || !table->is_object()) {
    return std::nullopt;
  }
  return NamesReader(document, mesh).read(*table);
}

std::optional<FeatureIds> feature_ids(GltfDocument& document, std::size_t mesh,
                                      std::size_t primitive,
                                      std::span<const std::uint32_t> vertices, std::size_t count) {
  const json& from = document.json["meshes"][mesh]["primitives"][primitive];
  const auto warn = [&](const std::string& what) {
    document.warnings.push_back(
        fmt::format("meshes[{}]: primitives[{}]: EXT_mesh_features: {}", mesh, primitive, what));
  };
  const auto extensions = from.find("extensions");
  if (extensions == from.end() || !extensions->contains("EXT_mesh_features")) {
    return std::nullopt;
  }
  const json& ours = (*extensions)["EXT_mesh_features"];
  const json sets = ours.is_object() ? ours.value("featureIds", json()) : json();
  if (!sets.is_array() || sets.empty()) {
    warn("has no feature ids");
    return std::nullopt;
  }
  const auto readable = std::ranges::find_if(
      sets, [](const json& set) { return set.is_object() && !set.contains("texture"); });
  if (readable == sets.end()) {
    warn("feature ids in textures are not read, and faces are found by angle");
    return std::nullopt;
  }
  const std::optional<std::uint32_t> features = id(*readable, "featureCount");
  const std::optional<std::uint32_t> null_feature = id(*readable, "nullFeatureId");
  const bool implicit = !readable->contains("attribute");
  std::optional<GltfAccessor> values;
  if (!implicit) {
    const std::optional<std::uint32_t> set = id(*readable, "attribute");
    const auto& attributes = document.model.meshes[mesh].primitives[primitive].attributes;
    const auto found = attributes.find(fmt::format("_FEATURE_ID_{}", set.value_or(0)));
    if (set && found != attributes.end()) {
      values.emplace(document, static_cast<std::size_t>(found->second));
    }
    if (!values || values->components() != 1 || values->size() < count) {
      warn("has no attribute with an id for each vertex and is ignored");
      return std::nullopt;
    }
  }
  FeatureIds out;
  std::uint32_t largest = 0;
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  for (const std::uint32_t vertex : vertices) {
    const double value = values ? std::round((*values)[vertex].x) : static_cast<double>(vertex);
    const double end = features ? static_cast<double>(*features) : static_cast<double>(none);
    if (null_feature && value == static_cast<double>(*null_feature)) {
      out.of_vertex.push_back(none);
      continue;
    }
    if (!(value >= 0.0 && value < end)) {
      warn(fmt::format("vertex {} has feature {}, which is none of {}, and all are ignored", vertex,
                       value, end));
      return std::nullopt;
    }
    out.of_vertex.push_back(static_cast<std::uint32_t>(value));
    largest = std::max(largest, out.of_vertex.back());
  }
  // Numbers far beyond what the vertices can use are no numbers of faces: their order is kept.
  if (largest >= std::max<std::size_t>(vertices.size(), std::size_t{1} << 16)) {
    std::vector<std::uint32_t> used = out.of_vertex;
    std::ranges::sort(used);
    used.erase(std::ranges::unique(used).begin(), used.end());
    for (std::uint32_t& feature : out.of_vertex) {
      feature =
          feature == none
              ? none
              : static_cast<std::uint32_t>(std::ranges::lower_bound(used, feature) - used.begin());
    }
    largest = static_cast<std::uint32_t>(used.size());
  }
  const bool any_none = std::ranges::find(out.of_vertex, none) != out.of_vertex.end();
  std::ranges::replace(out.of_vertex, none, largest + 1);
  out.count = largest + (any_none ? 2 : 1);
  return out;
}

}  // namespace raycat
