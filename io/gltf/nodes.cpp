#include "io/gltf/nodes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/files/name_or_number.hpp"

namespace raycat {
namespace {

glm::dmat4 local_matrix(const GltfDocument& document, std::size_t number) {
  const tinygltf::Node& node = document.model.nodes[number];
  glm::dmat4 matrix(1.0);
  if (!node.matrix.empty()) {
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    }
    return matrix;
  }
  if (!node.rotation.empty()) {
    const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1],
                              node.rotation[2]);
    const double length = glm::length(rotation);
    if (!(length > 0.0) || !std::isfinite(length)) {
      throw LoadError(document.file, document.node_place(number),
                      "rotation: a quaternion of no length");
    }
    matrix = glm::mat4_cast(rotation / length);
  }
  for (int c = 0; c < 3 && !node.scale.empty(); ++c) {
    matrix[c] *= node.scale[static_cast<std::size_t>(c)];
  }
  for (int c = 0; c < 3 && !node.translation.empty(); ++c) {
    matrix[3][c] = node.translation[static_cast<std::size_t>(c)];
  }
  return matrix;
}

bool visible(const GltfDocument& document, std::size_t node) {
  auto own = document.extension(document.json["nodes"][node], "KHR_node_visibility",
                                document.node_place(node));
  return !own || own->boolean("visible").value_or(true);
}

std::size_t find_scene(const GltfDocument& document, const std::string& wanted) {
  const auto& scenes = document.model.scenes;
  std::vector<std::string> names;
  for (const tinygltf::Scene& scene : scenes) {
    names.push_back(scene.name);
  }
  const auto number = name_or_number(names, wanted);
  if (!number) {
    throw LoadError(
        document.file, "scenes",
        fmt::format("none is called '{}'; the file has {}", excerpt(wanted), scenes.size()));
  }
  return *number;
}

GltfNodes walk(const GltfDocument& document, const std::vector<std::size_t>& roots) {
  GltfNodes nodes;
  nodes.world.assign(document.model.nodes.size(), glm::dmat4(1.0));
  nodes.hidden.assign(document.model.nodes.size(), false);
  std::vector<bool> seen(document.model.nodes.size());
  for (const std::size_t root : roots) {
    std::vector<std::size_t> pending{root};
    while (!pending.empty()) {
      const std::size_t node = pending.back();
      pending.pop_back();
      // A scene may name a node twice, or one below another: it is still there once.
      if (seen[node]) {
        continue;
      }
      seen[node] = true;
      nodes.order.push_back(node);
      nodes.world[node] = local_matrix(document, node);
      nodes.hidden[node] = !visible(document, node);
      if (node != root) {
        const std::size_t parent = *document.parents[node];
        nodes.world[node] = nodes.world[parent] * nodes.world[node];
        nodes.hidden[node] = nodes.hidden[node] || nodes.hidden[parent];
      }
      const auto& children = document.model.nodes[node].children;
      pending.insert(pending.end(), children.rbegin(), children.rend());
    }
  }
  return nodes;
}

}  // namespace

GltfNodes scene_nodes(const GltfDocument& document, const std::string& wanted) {
  const auto& model = document.model;
  std::vector<std::size_t> roots;
  if (!model.scenes.empty() || !wanted.empty()) {
    const auto& scene =
        model.scenes[wanted.empty() ? static_cast<std::size_t>(std::max(model.defaultScene, 0))
                                    : find_scene(document, wanted)];
    roots.assign(scene.nodes.begin(), scene.nodes.end());
  } else {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      if (!document.parents[i]) {
        roots.push_back(i);
      }
    }
  }
  return walk(document, roots);
}

std::optional<GltfNodes> nodes_below(const GltfDocument& document, const std::string& name) {
  const auto found = std::ranges::find(document.model.nodes, name, &tinygltf::Node::name);
  if (found == document.model.nodes.end()) {
    return std::nullopt;
  }
  return walk(document, {static_cast<std::size_t>(found - document.model.nodes.begin())});
}

}  // namespace raycat
