#include "io/gltf/scene.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"
#include "io/files/load_error.hpp"
#include "io/gltf/animation.hpp"
#include "io/gltf/extras.hpp"
#include "io/gltf/material.hpp"
#include "io/gltf/mesh.hpp"
#include "io/gltf/node_mesh.hpp"
#include "io/gltf/shapes.hpp"
#include "io/gltf/textures.hpp"
#include "io/gltf/view.hpp"
#include "io/scene/assembly.hpp"
#include "io/scene/cut_material.hpp"
#include "io/scene/placement.hpp"

namespace raycat {
namespace {

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, GltfAssets& assets, bool first)
      : document_(open_gltf(file, assets.budget())),
        assets_(assets),
        first_(first),
        assembly_(file),
        textures_(document_, assembly_.out.scene.textures, assets.budget()),
        materials_(read_materials(document_, textures_, assets.options().back_faces)),
        meshes_(document_, materials_, assets.options(), textures_, assets.budget()),
        colliders_(document_),
        node_meshes_(document_, meshes_, nodes_, assets.budget()) {
    for (const GltfMaterial& material : materials_) {
      assembly_.out.scene.materials.push_back(material.material);
    }
  }

  SceneFile read(const std::optional<std::string>& node) {
    const LoadOptions& options = assets_.options();
    if (options.time && (first_ || document_.json.contains("animations"))) {
      pose_nodes(document_, *options.time, first_ ? options.animation : "");
    }
    auto below =
        node ? nodes_below(document_, *node) : scene_nodes(document_, first_ ? options.scene : "");
    if (!below) {
      throw LoadError(document_.file, "nodes",
                      fmt::format("no node is named '{}'", excerpt(*node)));
    }
    nodes_ = *std::move(below);
    SceneFile& out = assembly_.out;
    read_objects();
    out.scene.cameras = read_cameras(document_, nodes_);
    out.scene.lights = read_lights(document_, nodes_, assets_.options().exposure);
    read_surroundings(document_, out.scene);
    for (const auto& name : document_.json.value("extensionsUsed", nlohmann::json::array())) {
      out.extensions.push_back(name);
    }
    if (meshes_.undrawn() > 0) {
      document_.warnings.push_back(
          fmt::format("primitives of points or lines, which have no surface, are not drawn: {}",
                      meshes_.undrawn()));
    }
    if (hidden_colliders_ > 0) {
      document_.warnings.push_back(fmt::format(
          "physics shapes are not drawn where meshes are, nor without a closed form: {}",
          hidden_colliders_));
    }
    if (const auto& misstated = meshes_.misstated(); !misstated.empty()) {
      const std::span some(misstated.data(), std::min<std::size_t>(misstated.size(), 10));
      document_.warnings.push_back(fmt::format(
          "min or max is not that of the data, which count: accessors {}", fmt::join(some, ", ")));
    }
    out.warnings.insert(out.warnings.begin(), document_.warnings.begin(), document_.warnings.end());
    return std::move(out);
  }

 private:
  // A node of a CSG tree whose children are being read.
  struct Frame {
    std::size_t node = 0;
    NodeExtras extras;
    std::size_t next_child = 0;
    std::vector<CsgTree::NodeId> operands;
    std::size_t first_leaf = 0;
    std::size_t cut_leaf = 0;  // the first leaf that is subtracted
  };

  void read_objects() {
    in_tree_.assign(document_.model.nodes.size(), false);
    for (const std::size_t node : nodes_.order) {
      if (in_tree_[node]) {
        continue;
      }
      if (nodes_.hidden[node]) {
        // What is hidden is in the file all the same.
        assembly_.out.triangles +=
            document_.model.nodes[node].mesh < 0 ? 0 : node_meshes_.triangles(node);
        continue;
      }
      const NodeExtras extras = node_extras(document_, node);
      try {
        if (extras.csg || extras.shape) {
          read_solid(node, extras);
        } else if (extras.asset) {
          read_asset(node, *extras.asset);
        } else if (document_.model.nodes[node].mesh >= 0) {
          read_mesh(node);
        } else if (colliders_.at(node)) {
          read_collider(node);
        }
      } catch (const std::invalid_argument& error) {
        throw LoadError(document_.file, document_.node_place(node), error.what());
      }
    }
  }

  // Shapes of physics are seen where nothing else shows what they stand for.
  void read_collider(std::size_t node) {
    auto shape = colliders_.shown(node);
    if (!shape) {
      ++hidden_colliders_;
      return;
    }
    assembly_.add_object(document_.node_name(node));
    TreeAssembly tree;
    add_leaf(node, *std::move(shape), std::nullopt, tree);
    add_solid(std::move(tree));
  }

  MaterialId material(std::optional<std::size_t> number) {
    if (number) {
      return static_cast<MaterialId>(*number);
    }
    if (!default_material_) {
      auto& materials = assembly_.out.scene.materials;
      default_material_ = static_cast<MaterialId>(materials.size());
      materials.push_back(default_material(assets_.options().back_faces));
    }
    return *default_material_;
  }

  void read_mesh(std::size_t node) {
    const GltfMesh& rest = node_meshes_.at_rest(node);
    if (rest.primitives.empty()) {
      return;
    }
    const std::optional<GltfMesh> moved = node_meshes_.posed(node);
    for (const GltfInstanceGroup& group : node_meshes_.places(node)) {
      place_mesh(node, document_.node_name(node) + group.label, moved ? *moved : rest,
                 group.transforms);
    }
  }

  // One object: the mesh at each of the places.
  void place_mesh(std::size_t node, const std::string& name, const GltfMesh& mesh,
                  const std::vector<glm::dmat4>& places) {
    std::vector<Affine> transforms;
    for (const glm::dmat4& place : places) {
      try {
        transforms.emplace_back(place);
      } catch (const std::invalid_argument& error) {
        warn(node, fmt::format("{}; its mesh is left out", error.what()));
      }
    }
    if (transforms.empty()) {
      return;
    }
    SceneFile& out = assembly_.out;
    assembly_.add_object(name);
    for (const Affine& transform : transforms) {
      take_instance(node, mesh);
      const auto first = static_cast<std::uint32_t>(out.scene.surfaces.faces());
      add_surfaces(mesh, name);
      for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const GltfPrimitive& primitive = mesh.primitives[i];
        out.scene.meshes.push_back({.mesh = primitive.mesh,
                                    .transform = transform,
                                    .material = material(primitive.material),
                                    .first_face = SurfaceId{first + mesh.first_faces[i]}});
        out.triangles += primitive.triangles;
      }
    }
  }

  void take_instance(std::size_t node, const GltfMesh& mesh) {
    const std::string place = document_.node_place(node);
    assets_.budget().take_instances(document_.file, place, mesh.primitives.size());
    for (const GltfPrimitive& primitive : mesh.primitives) {
      assets_.budget().take_triangles(document_.file, place, primitive.triangles);
    }
  }

  void add_surfaces(const GltfMesh& mesh, const std::string& name) {
    if (mesh.names) {
      for (const FeatureNames::Primitive& primitive : mesh.names->primitives) {
        assembly_.add_primitive(primitive.name, primitive.faces);
      }
      return;
    }
    const std::vector<GltfSurface>& surfaces = mesh.surfaces.surfaces;
    for (const GltfSurface& surface : surfaces) {
      assembly_.add_primitive(
          surfaces.size() == 1 ? name : fmt::format("{}.{}", name, surface.first_primitive),
          surface.face_count);
    }
  }

  void read_solid(std::size_t node, const NodeExtras& extras) {
    assembly_.add_object(document_.node_name(node));
    TreeAssembly tree;
    if (extras.shape) {
      add_leaf(node, *extras.shape, extras.material, tree);
      warn_of_mesh(node);
    } else {
      read_tree(node, tree);
    }
    if (tree.tree.nodes().size() > 1) {
      assembly_.out.csg_nodes += tree.tree.nodes().size();
    }
    add_solid(std::move(tree));
  }

  void add_solid(TreeAssembly tree) {
    assembly_.out.scene.solids.push_back(
        {.solid = Solid(std::move(tree.tree)), .materials = std::move(tree.materials)});
  }

  void add_leaf(std::size_t node, Shape shape, std::optional<std::size_t> number,
                TreeAssembly& tree) {
    add_leaf(node, std::move(shape), number, nodes_.world[node], tree);
  }

  void add_leaf(std::size_t node, Shape shape, std::optional<std::size_t> number,
                const glm::dmat4& world, TreeAssembly& tree) {
    PlacedShape placed(std::move(shape), Affine(world));
    const SurfaceId first = assembly_.add_primitive(document_.node_name(node), placed.face_count());
    tree.materials.push_back(material(number));
    last_added_ = tree.tree.add(CsgLeaf{.shape = std::move(placed), .first_face = first});
  }

  // Children before parents, without recursion: trees are as deep as their authors like.
  void read_tree(std::size_t root, TreeAssembly& tree) {
    std::vector<Frame> frames;
    frames.push_back(enter(root, tree));
    while (!frames.empty()) {
      Frame& frame = frames.back();
      const auto& children = document_.model.nodes[frame.node].children;
      if (frame.next_child < children.size()) {
        const auto child = static_cast<std::size_t>(children[frame.next_child++]);
        if (nodes_.hidden[child]) {
          continue;
        }
        if (frame.operands.size() <= 1) {
          frame.cut_leaf = tree.tree.leaves().size();
        }
        frames.push_back(enter(child, tree));
        continue;
      }
      const auto node = leave(frame, tree);
      frames.pop_back();
      if (node && !frames.empty()) {
        frames.back().operands.push_back(*node);
      }
    }
    std::exchange(cuts_, {}).apply(tree.materials);
  }

  Frame enter(std::size_t node, TreeAssembly& tree) {
    Frame frame{.node = node,
                .extras = node_extras(document_, node),
                .first_leaf = tree.tree.leaves().size()};
    in_tree_[node] = true;
    try {
      if (frame.extras.shape) {
        add_leaf(node, *frame.extras.shape, frame.extras.material, tree);
        frame.operands.push_back(last_added_);
      } else if (frame.extras.asset) {
        frame.operands = read_asset_operands(node, *frame.extras.asset, tree);
      } else if (!frame.extras.csg && document_.model.nodes[node].mesh >= 0) {
        frame.operands = add_mesh_leaves(node, tree);
        return frame;
      }
      warn_of_mesh(node);
    } catch (const std::invalid_argument& error) {
      throw LoadError(document_.file, document_.node_place(node), error.what());
    }
    return frame;
  }

  // The mesh at each of its places, in its pose, as an operand.
  std::vector<CsgTree::NodeId> add_mesh_leaves(std::size_t node, TreeAssembly& tree) {
    const GltfMesh& rest = node_meshes_.at_rest(node);
    const MeshShape shape = node_meshes_.solid(node);
    std::optional<std::size_t> material;
    if (!rest.primitives.empty()) {
      material = rest.primitives.front().material;
    }
    std::vector<CsgTree::NodeId> operands;
    for (const GltfInstanceGroup& group : node_meshes_.places(node)) {
      for (const glm::dmat4& place : group.transforms) {
        assets_.budget().take_instances(document_.file, document_.node_place(node), 1);
        add_leaf(node, shape, material, place, tree);
        operands.push_back(last_added_);
      }
    }
    return operands;
  }

  // The node in the tree that a glTF node stands for; none for cameras, lights and what only
  // holds those.
  std::optional<CsgTree::NodeId> leave(Frame& frame, TreeAssembly& tree) {
    const auto& node = document_.model.nodes[frame.node];
    if (frame.operands.empty()) {
      if (frame.extras.csg) {
        throw LoadError(document_.file, document_.node_place(frame.node),
                        "extras.csg: has no operands below it");
      }
      if (node.children.empty() && node.camera < 0 && !has_light(frame.node)) {
        throw LoadError(document_.file, document_.node_place(frame.node),
                        "a CSG operand must be a shape, a mesh or a csg node");
      }
      return std::nullopt;
    }
    if (frame.extras.cut_material == CutMaterial::base &&
        frame.extras.csg == Operation::difference && frame.operands.size() > 1) {
      cuts_.add(frame.cut_leaf, tree.tree.leaves().size(), frame.first_leaf);
    }
    if (frame.operands.size() == 1 && !frame.extras.csg) {
      return frame.operands.front();
    }
    return tree.tree.add(frame.extras.csg.value_or(Operation::set_union), frame.operands);
  }

  bool has_light(std::size_t node) const {
    return document_
        .extension(document_.json["nodes"][node], "KHR_lights_punctual", document_.node_place(node))
        .has_value();
  }

  Placement placement(std::size_t node, const SceneFile& part) {
    // An asset is a line in the file that places it, but may itself be large.
    const std::string place = document_.node_place(node);
    assets_.budget().take_instances(document_.file, place,
                                    std::max<std::size_t>(part.scene.surfaces.primitives(), 1));
    assets_.budget().take_triangles(document_.file, place, part.triangles);
    auto [first, added] = asset_materials_.try_emplace(&part);
    if (added) {
      first->second = add_materials(part.scene, assembly_.out.scene);
      for (const std::string& warning : part.warnings) {
        warn(node, warning);
      }
    }
    return {.world = nodes_.world[node],
            .name = document_.node_name(node),
            .first_material = first->second};
  }

  void read_asset(std::size_t node, const NodeExtras::Asset& asset) {
    const auto part = assets_.load(document_, node, asset);
    place_objects(part->scene, placement(node, *part), assembly_);
    assembly_.out.triangles += part->triangles;
    assembly_.out.csg_nodes += part->csg_nodes;
    warn_of_mesh(node);
  }

  std::vector<CsgTree::NodeId> read_asset_operands(std::size_t node, const NodeExtras::Asset& asset,
                                                   TreeAssembly& tree) {
    const auto part = assets_.load(document_, node, asset);
    return place_operands(part->scene, placement(node, *part), assembly_, tree);
  }

  // Tools that do not know our extras may show a mesh in place of what they say.
  void warn_of_mesh(std::size_t node) {
    if (document_.model.nodes[node].mesh >= 0) {
      warn(node, "its mesh is ignored beside its extras");
    }
  }

  void warn(std::size_t node, const std::string& what) {
    assembly_.out.warnings.push_back(fmt::format("{}: {}", document_.node_place(node), what));
  }

  GltfDocument document_;
  GltfAssets& assets_;
  bool first_;  // is this the file that was asked for, rather than one that it places?
  SceneAssembly assembly_;
  GltfTextures textures_;
  std::vector<GltfMaterial> materials_;
  GltfMeshes meshes_;
  GltfColliders colliders_;
  GltfNodes nodes_;
  GltfNodeMeshes node_meshes_;
  std::vector<bool> in_tree_;  // nodes that a CSG tree above them has taken in
  std::size_t hidden_colliders_ = 0;
  std::optional<MaterialId> default_material_;
  CsgTree::NodeId last_added_{};
  CutMaterials cuts_;  // of the tree being read
  std::map<const SceneFile*, std::uint32_t> asset_materials_;
};

}  // namespace

SceneFile read_gltf_scene(const std::filesystem::path& file, const std::optional<std::string>& node,
                          GltfAssets& assets) {
  return SceneReader(file, assets, !assets.nested()).read(node);
}

}  // namespace raycat
