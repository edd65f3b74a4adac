#include "io/gltf/instances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "io/files/load_error.hpp"
#include "io/gltf/accessor.hpp"

namespace raycat {
namespace {

class Instancing {
 public:
  Instancing(GltfDocument& document, std::size_t node, JsonFields fields)
      : document_(document), place_(document.node_place(node)) {
    for (const auto& [name, number] : fields.whole_numbers("attributes")) {
      if (number >= document.model.accessors.size()) {
        fail(fmt::format("{}: there is no accessors[{}]; the file has {}", name, number,
                         document.model.accessors.size()));
      }
      numbers_[name] = number;
      const std::size_t size = document.model.accessors[number].count;
      if (count_ && size != *count_) {
        fail(fmt::format("attributes: {} has {} elements where another has {}", name, size,
                         *count_));
      }
      count_ = size;
    }
  }

  std::size_t count() const noexcept { return count_.value_or(0); }

  std::vector<glm::dmat4> transforms() const {
    const auto translations = attribute("TRANSLATION", 3);
    const auto rotations = attribute("ROTATION", 4);
    const auto scales = attribute("SCALE", 3);
    std::vector<glm::dmat4> transforms;
    transforms.reserve(count());
    for (std::size_t i = 0; i < count(); ++i) {
      glm::dmat4 transform(1.0);
      if (rotations) {
        const glm::dvec4 r = (*rotations)[i];
        const glm::dquat rotation(r.w, r.x, r.y, r.z);
        const double length = glm::length(rotation);
        if (!(length > 0.0) || !std::isfinite(length)) {
          fail(fmt::format("ROTATION: instance {} has a quaternion of no length", i));
        }
        transform = glm::mat4_cast(rotation / length);
      }
      if (scales) {
        transform = glm::scale(transform, glm::dvec3((*scales)[i]));
      }
      if (translations) {
        transform[3] = glm::dvec4(glm::dvec3((*translations)[i]), 1.0);
      }
      transforms.push_back(transform);
    }
    return transforms;
  }

  std::optional<GltfAccessor> attribute(const std::string& name, int components) const {
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) {
      return std::nullopt;
    }
    GltfAccessor accessor(document_, found->second);
    if (accessor.components() != components) {
      fail(fmt::format("{}: accessors[{}] has {} components", name, found->second,
                       accessor.components()));
    }
    return accessor;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw LoadError(document_.file, place_, "EXT_mesh_gpu_instancing: " + what);
  }

 private:
  const GltfDocument& document_;
  std::string place_;
  std::map<std::string, std::size_t> numbers_;
  std::optional<std::size_t> count_;
};

// The id of each instance by the first set of EXT_instance_features; none for the null feature.
std::optional<std::vector<std::optional<double>>> features(GltfDocument& document, std::size_t node,
                                                           const Instancing& instances) {
  const std::string place = document.node_place(node);
  const auto warn = [&](const std::string& what) {
    document.warnings.push_back(
        fmt::format("{}: EXT_instance_features: {}; each instance is an object", place, what));
    return std::nullopt;
  };
  const auto& json = document.json["nodes"][node];
  const auto extensions = json.find("extensions");
  if (extensions == json.end() || !extensions->contains("EXT_instance_features")) {
    return std::nullopt;
  }
  const auto& sets = extensions->at("EXT_instance_features");
  if (!sets.is_object() || !sets.contains("featureIds") || !sets["featureIds"].is_array() ||
      sets["featureIds"].empty() || !sets["featureIds"][0].is_object()) {
    return warn("has no feature ids");
  }
  JsonFields set(document.file, place, "EXT_instance_features", sets["featureIds"][0]);
  const auto null_feature = set.whole("nullFeatureId");
  const auto number = set.whole("attribute");
  std::optional<GltfAccessor> values;
  if (number) {
    values = instances.attribute(fmt::format("_FEATURE_ID_{}", *number), 1);
    if (!values) {
      return warn(fmt::format("there is no attribute _FEATURE_ID_{}", *number));
    }
  }
  std::vector<std::optional<double>> ids(instances.count());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const double id = values ? std::round((*values)[i].x) : static_cast<double>(i);
    if (!(id >= 0.0 && id < 0x1p53)) {
      return warn(fmt::format("instance {} has the id {}", i, id));
    }
    if (!null_feature || id != static_cast<double>(*null_feature)) {
      ids[i] = id;
    }
  }
  return ids;
}

}  // namespace

std::optional<std::vector<GltfInstanceGroup>> instance_groups(GltfDocument& document,
                                                              std::size_t node,
                                                              LoadBudget& budget) {
  const std::string place = document.node_place(node);
  auto fields = document.extension(document.json["nodes"][node], "EXT_mesh_gpu_instancing", place);
  if (!fields) {
    return std::nullopt;
  }
  const Instancing instancing(document, node, *std::move(fields));
  budget.take_memory(document.file, place, instancing.count(), 2 * sizeof(glm::dmat4));
  const std::vector<glm::dmat4> transforms = instancing.transforms();
  const auto ids = features(document, node, instancing);
  std::vector<GltfInstanceGroup> groups;
  std::map<double, std::size_t> group_of;
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const std::optional<double> id = ids ? (*ids)[i] : std::nullopt;
    if (!id) {
      groups.push_back(
          {.label = fmt::format("[{}]", ids ? "none " + std::to_string(i) : std::to_string(i)),
           .transforms = {transforms[i]}});
      continue;
    }
    const auto [found, added] = group_of.try_emplace(*id, groups.size());
    if (added) {
      groups.push_back(
          {.label = fmt::format("[{}]", static_cast<std::uint64_t>(*id)), .transforms = {}});
    }
    groups[found->second].transforms.push_back(transforms[i]);
  }
  return groups;
}

}  // namespace raycat
