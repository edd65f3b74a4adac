#include "io/gltf/features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"

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

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::optional<std::uint32_t> id(const json& set, const char* key) {
  const auto found = set.find(key);
  if (found == set.end() || !found->is_number_unsigned() || found->get<std::uint64_t>() >= none) {
    return std::nullopt;
  }
  return found->get<std::uint32_t>();
}

// The first set of feature ids of a primitive, and what they mean.
class FeatureSet {
 public:
  /// Nothing if there is none, with a warning if `tells` and there should be.
  static std::optional<FeatureSet> first(GltfDocument& document, std::size_t mesh,
                                         std::size_t primitive, bool tells) {
    const json& from = document.json["meshes"][mesh]["primitives"][primitive];
    const auto extensions = from.find("extensions");
    if (extensions == from.end() || !extensions->contains("EXT_mesh_features")) {
      return std::nullopt;
    }
    const json& ours = (*extensions)["EXT_mesh_features"];
    const auto sets = ours.find("featureIds");
    FeatureSet out(document,
                   fmt::format("meshes[{}]: primitives[{}]: EXT_mesh_features", mesh, primitive));
    if (!ours.is_object() || sets == ours.end() || !sets->is_array() || sets->empty() ||
        !sets->front().is_object()) {
      if (tells) {
        out.warn("has no feature ids");
      }
      return std::nullopt;
    }
    out.json_ = &sets->front();
    out.end_ = id(*out.json_, "featureCount").value_or(none);
    out.null_ = id(*out.json_, "nullFeatureId");
    return out;
  }

  const json& fields() const { return *json_; }
  const std::string& place() const { return place_; }
  std::uint32_t end() const { return end_; }

  void warn(const std::string& what) const {
    document_->warnings.push_back(fmt::format("{}: {}", place_, what));
  }

  /// The feature that a value of the file stands for, which may be `none`; nothing if it is none
  /// that there can be.
  std::optional<std::uint32_t> feature(double value) const {
    if (null_ && value == static_cast<double>(*null_)) {
      return none;
    }
    if (!(value >= 0.0 && value < static_cast<double>(end_))) {
      return std::nullopt;
    }
    return static_cast<std::uint32_t>(value);
  }

 private:
  FeatureSet(GltfDocument& document, std::string place)
      : document_(&document), place_(std::move(place)) {}

  GltfDocument* document_;
  std::string place_;
  const json* json_ = nullptr;
  std::uint32_t end_ = none;
  std::optional<std::uint32_t> null_;
};

// Numbers far beyond what there are values for are no numbers of faces: their order is kept.
FeatureIds numbered(std::vector<std::uint32_t> features) {
  std::uint32_t end = 0;
  bool any_none = false;
  for (const std::uint32_t feature : features) {
    any_none = any_none || feature == none;
    end = feature == none ? end : std::max(end, feature + 1);
  }
  if (end > std::max<std::size_t>(features.size(), std::size_t{1} << 16)) {
    std::vector<std::uint32_t> used = features;
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::uint32_t& feature : features) {
      feature =
          feature == none
              ? none
              : static_cast<std::uint32_t>(std::ranges::lower_bound(used, feature) - used.begin());
    }
    end = static_cast<std::uint32_t>(used.size() - (any_none ? 1 : 0));
  }
  std::ranges::replace(features, none, end);
  return {.numbers = std::move(features), .count = end + (any_none ? 1 : 0)};
}

// Which of a texel's bytes make up an id, the lowest first; nothing if that is not told well.
std::optional<std::vector<std::size_t>> channels(const json& texture) {
  const auto found = texture.find("channels");
  if (found == texture.end()) {
    return std::vector<std::size_t>{0};
  }
  std::vector<std::size_t> out;
  for (const json& channel : found->is_array() ? *found : json::array()) {
    if (!is_whole(channel) || channel.get<std::uint64_t>() > 3) {
      return std::nullopt;
    }
    out.push_back(channel);
  }
  return out.empty() || out.size() > 4 ? std::nullopt : std::optional(std::move(out));
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
  const auto set = FeatureSet::first(document, mesh, primitive, true);
  if (!set || set->fields().contains("texture")) {
    return std::nullopt;
  }
  std::optional<GltfAccessor> values;  // without them a vertex is its own feature
  if (set->fields().contains("attribute")) {
    const auto number = id(set->fields(), "attribute");
    const auto& attributes = document.model.meshes[mesh].primitives[primitive].attributes;
    const auto found = attributes.find(fmt::format("_FEATURE_ID_{}", number.value_or(0)));
    if (number && found != attributes.end()) {
      values.emplace(document, static_cast<std::size_t>(found->second));
    }
    if (!values || values->components() != 1 || values->size() < count) {
      set->warn("has no attribute with an id for each vertex and is ignored");
      return std::nullopt;
    }
  }
  std::vector<std::uint32_t> features;
  features.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices) {
    const double value = values ? std::round((*values)[vertex].x) : static_cast<double>(vertex);
    const auto feature = set->feature(value);
    if (!feature) {
      set->warn(fmt::format("vertex {} has feature {}, which is none of {}, and all are ignored",
                            vertex, value, set->end()));
      return std::nullopt;
    }
    features.push_back(*feature);
  }
  return numbered(std::move(features));
}

std::optional<TexturedFeatures> feature_map(GltfDocument& document, std::size_t mesh,
                                            std::size_t primitive, GltfTextures& textures,
                                            CoordinateSets& sets) {
  const auto set = FeatureSet::first(document, mesh, primitive, false);
  if (!set || !set->fields().contains("texture")) {
    return std::nullopt;
  }
  const json& texture = set->fields()["texture"];
  const auto bytes = texture.is_object() ? channels(texture) : std::nullopt;
  if (!bytes) {
    set->warn("texture: has no channels from 0 to 3, and faces are found by angle");
    return std::nullopt;
  }
  JsonFields fields(document.file, set->place(), "texture", texture);
  const GltfTextureInfo info = textures.info(fields, sets);
  auto image = textures.texels(info.texture);
  if (!image) {
    set->warn("its image cannot be read, and faces are found by angle");
    return std::nullopt;
  }
  const auto& [grid, rgba] = *image;
  std::vector<std::uint32_t> features(rgba.size() / 4);
  std::size_t strange = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < bytes->size(); ++k) {
      value |= std::uint32_t{rgba[4 * i + (*bytes)[k]]} << (8 * k);
    }
    const auto feature = set->feature(value);
    strange += feature ? 0U : 1U;
    features[i] = feature.value_or(none);
  }
  if (strange > 0) {
    set->warn(fmt::format("{} texels have a feature that is none of {}; they count as having none",
                          strange, set->end()));
  }
  FeatureIds ids = numbered(std::move(features));
  return TexturedFeatures{.map = std::make_shared<const FeatureMap>(FeatureMap{
                              .grid = grid, .faces = std::move(ids.numbers), .place = info.place}),
                          .count = ids.count};
}

}  // namespace raycat
