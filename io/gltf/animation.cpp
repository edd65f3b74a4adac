#include "io/gltf/animation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/files/name_or_number.hpp"
#include "io/gltf/accessor.hpp"

namespace raycat {
namespace {

using nlohmann::json;
using Values = std::vector<double>;

/// Where a time lies among key frames: between `frame` and the next, at `share` of the way.
struct KeyTime {
  std::size_t frame = 0;
  double share = 0.0;
  double span = 0.0;  // seconds from the one to the other
};

KeyTime key_time(const GltfAccessor& times, double time) {
  std::size_t low = 0;
  std::size_t high = times.size() - 1;
  if (time <= times[low].x) {
    return {.frame = low};
  }
  if (time >= times[high].x) {
    return {.frame = high};
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (times[middle].x <= time ? low : high) = middle;
  }
  const double span = times[high].x - times[low].x;
  return {.frame = low, .share = (time - times[low].x) / span, .span = span};
}

glm::dquat quaternion(const double* v) { return {v[3], v[0], v[1], v[2]}; }

/// One channel's key frames, of `width` numbers each.
class Sampler {
 public:
  Sampler(const GltfAccessor& times, const GltfAccessor& values, std::string interpolation,
          std::size_t width, bool rotation)
      : times_(times),
        values_(values),
        interpolation_(std::move(interpolation)),
        width_(width),
        rotation_(rotation) {
    if (interpolation_ != "LINEAR" && interpolation_ != "STEP" && interpolation_ != "CUBICSPLINE") {
      throw std::runtime_error(
          fmt::format("interpolation '{}' is not one of glTF 2.0", excerpt(interpolation_)));
    }
    if (times_.components() != 1 || times_.size() == 0) {
      throw std::runtime_error("its input holds no times");
    }
    const std::size_t parts = interpolation_ == "CUBICSPLINE" ? 3 : 1;
    const std::size_t each = width_ * parts / static_cast<std::size_t>(values_.components());
    if (each == 0 || values_.size() / each < times_.size()) {
      throw std::runtime_error(fmt::format("its output has {} elements for {} key frames",
                                           values_.size(), times_.size()));
    }
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (!std::isfinite(times_[i].x) || (i > 0 && !(times_[i].x > times_[i - 1].x))) {
        throw std::runtime_error(fmt::format("its input does not increase at key frame {}", i));
      }
    }
  }

  Values at(double time) const {
    const KeyTime key = key_time(times_, time);
    if (interpolation_ == "CUBICSPLINE") {
      return cubic(key);
    }
    Values from = part(key.frame);
    if (interpolation_ == "STEP" || key.share == 0.0) {
      return from;
    }
    const Values to = part(key.frame + 1);
    if (rotation_) {
      const glm::dquat turned = glm::slerp(glm::normalize(quaternion(from.data())),
                                           glm::normalize(quaternion(to.data())), key.share);
      return {turned.x, turned.y, turned.z, turned.w};
    }
    for (std::size_t i = 0; i < width_; ++i) {
      from[i] += key.share * (to[i] - from[i]);
    }
    return from;
  }

 private:
  // The n-th run of `width` numbers.
  Values part(std::size_t n) const {
    Values values;
    const auto components = static_cast<std::size_t>(values_.components());
    for (std::size_t i = n * width_; i < (n + 1) * width_; ++i) {
      values.push_back(values_[i / components][static_cast<int>(i % components)]);
    }
    return values;
  }

  // Of each key frame the in-tangent, the value and the out-tangent.
  Values cubic(const KeyTime& key) const {
    Values out = part(3 * key.frame + 1);
    if (key.span == 0.0) {
      return out;
    }
    const Values leaving = part(3 * key.frame + 2);
    const Values arriving = part(3 * key.frame + 3);
    const Values to = part(3 * key.frame + 4);
    const double t = key.share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    for (std::size_t i = 0; i < width_; ++i) {
      out[i] = (2 * t3 - 3 * t2 + 1) * out[i] + key.span * (t3 - 2 * t2 + t) * leaving[i] +
               (-2 * t3 + 3 * t2) * to[i] + key.span * (t3 - t2) * arriving[i];
    }
    return out;
  }

  const GltfAccessor& times_;
  const GltfAccessor& values_;
  std::string interpolation_;
  std::size_t width_;
  bool rotation_;
};

std::size_t index_in(const json& object, const char* key, std::size_t size) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || found == object.end() || !is_whole(*found) ||
      found->get<std::uint64_t>() >= size) {
    throw std::runtime_error(fmt::format("its {} names nothing", key));
  }
  return found->get<std::size_t>();
}

const json& member(const json& object, const char* key) {
  static const json nothing;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : nothing;
}

// How many numbers the path of a channel has at each key frame.
std::size_t width_of(const GltfDocument& document, const tinygltf::Node& node,
                     const std::string& path) {
  if (path == "translation" || path == "scale") {
    return 3;
  }
  if (path == "rotation") {
    return 4;
  }
  if (path != "weights") {
    throw std::runtime_error(fmt::format("path '{}' is not one of glTF 2.0", excerpt(path)));
  }
  const auto* mesh =
      node.mesh < 0 ? nullptr : &document.model.meshes[static_cast<std::size_t>(node.mesh)];
  if (mesh == nullptr || mesh->primitives.empty() || mesh->primitives.front().targets.empty()) {
    throw std::runtime_error("its node has no morph targets");
  }
  return mesh->primitives.front().targets.size();
}

void apply(GltfDocument& document, const json& samplers, const json& channel, double time) {
  const json& target = member(channel, "target");
  if (target.is_object() && !target.contains("node")) {
    return;  // an extension's, or nothing's
  }
  tinygltf::Node& node =
      document.model.nodes[index_in(target, "node", document.model.nodes.size())];
  const json& sampler = samplers[index_in(channel, "sampler", samplers.size())];
  const json& path = member(target, "path");
  const json& interpolation = member(sampler, "interpolation");
  if (!path.is_string() || !(interpolation.is_null() || interpolation.is_string())) {
    throw std::runtime_error("its path or interpolation is no string");
  }
  const std::size_t accessors = document.model.accessors.size();
  const GltfAccessor times(document, index_in(sampler, "input", accessors));
  const GltfAccessor values(document, index_in(sampler, "output", accessors));
  if (values.components() == 0) {
    throw std::runtime_error("its output holds matrices");
  }
  const Values posed = Sampler(times, values, interpolation.is_null() ? "LINEAR" : interpolation,
                               width_of(document, node, path), path == "rotation")
                           .at(time);
  if (!std::ranges::all_of(posed, [](double value) { return std::isfinite(value); })) {
    throw std::runtime_error("its output is not finite");
  }
  if (path == "weights") {
    node.weights = posed;
    return;
  }
  if (!node.matrix.empty()) {
    throw std::runtime_error("its node has a matrix, which cannot be animated");
  }
  (path == "translation" ? node.translation
   : path == "rotation"  ? node.rotation
                         : node.scale) = posed;
}

const json& find_animation(const GltfDocument& document, const std::string& wanted) {
  const json& all = member(document.json, "animations");
  if (!all.is_array() || all.empty()) {
    throw LoadError(document.file, "animations", "there are none to take a pose from");
  }
  if (wanted.empty()) {
    return all[0];
  }
  std::vector<std::string> names;
  for (const json& animation : all) {
    const json& name = member(animation, "name");
    names.push_back(name.is_string() ? name.get<std::string>() : "");
  }
  const auto number = name_or_number(names, wanted);
  if (!number) {
    throw LoadError(
        document.file, "animations",
        fmt::format("none is called '{}'; the file has {}", excerpt(wanted), all.size()));
  }
  return all[*number];
}

}  // namespace

void pose_nodes(GltfDocument& document, double time, const std::string& animation) {
  const json& from = find_animation(document, animation);
  const json& channels = member(from, "channels");
  const json& samplers = member(from, "samplers");
  for (std::size_t i = 0; channels.is_array() && i < channels.size(); ++i) {
    try {
      apply(document, samplers.is_array() ? samplers : json::array(), channels[i], time);
    } catch (const std::runtime_error& error) {
      document.warnings.push_back(
          fmt::format("animations: channels[{}]: {}; it is left out", i, error.what()));
    }
  }
}

}  // namespace raycat
