#include "io/scene/placement.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "geometry/joined_mesh.hpp"

namespace raycat {
namespace {

// One object of a scene: a solid or some mesh instances.
struct Parts {
  const SolidObject* solid = nullptr;
  std::vector<const MeshInstance*> meshes;
};

std::vector<Parts> objects(const Scene& scene) {
  std::vector<Parts> objects(scene.surfaces.objects());
  const auto object_of = [&](SurfaceId face) -> Parts& {
    return objects[static_cast<std::size_t>(scene.surfaces.object(face))];
  };
  for (const SolidObject& solid : scene.solids) {
    object_of(solid.solid.tree().leaves().front().first_face).solid = &solid;
  }
  for (const MeshInstance& mesh : scene.meshes) {
    object_of(mesh.first_face).meshes.push_back(&mesh);
  }
  return objects;
}

Affine placed(const Affine& transform, const Placement& placement) {
  return Affine(placement.world * transform.matrix());
}

MaterialId placed(MaterialId material, const Placement& placement) {
  return MaterialId{placement.first_material + static_cast<std::uint32_t>(material)};
}

std::string placed(const std::string& name, const Placement& placement) {
  return placement.name + "/" + name;
}

std::uint32_t distance(SurfaceId from, SurfaceId to) {
  return static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
}

std::string primitive_name(const Scene& scene, SurfaceId face) {
  return scene.surfaces.name(scene.surfaces.primitive(face));
}

CsgTree::NodeId add_leaf(const Scene& part, const CsgLeaf& leaf, MaterialId material,
                         const Placement& placement, SceneAssembly& to, TreeAssembly& tree) {
  PlacedShape shape(leaf.shape.shape(), placed(leaf.shape.transform(), placement));
  const SurfaceId first = to.add_primitive(placed(primitive_name(part, leaf.first_face), placement),
                                           shape.face_count());
  tree.materials.push_back(placed(material, placement));
  return tree.tree.add(CsgLeaf{.shape = std::move(shape), .first_face = first});
}

CsgTree::NodeId add_tree(const Scene& part, const SolidObject& solid, const Placement& placement,
                         SceneAssembly& to, TreeAssembly& tree) {
  const auto nodes = solid.solid.tree().nodes();
  const auto leaves = solid.solid.tree().leaves();
  std::vector<std::vector<std::size_t>> children(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent != CsgTree::no_parent) {
      auto& siblings = children[nodes[i].parent];
      siblings.push_back(i);
      // What is subtracted from goes first, wherever it was added.
      if (nodes[nodes[i].parent].operation == Operation::difference && !nodes[i].subtracted) {
        std::swap(siblings.front(), siblings.back());
      }
    }
  }
  std::vector<CsgTree::NodeId> copies(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].leaf != CsgTree::no_leaf) {
      copies[i] = add_leaf(part, leaves[nodes[i].leaf], solid.materials[nodes[i].leaf], placement,
                           to, tree);
      continue;
    }
    std::vector<CsgTree::NodeId> operands;
    for (const std::size_t child : children[i]) {
      operands.push_back(copies[child]);
    }
    copies[i] = tree.tree.add(nodes[i].operation, operands);
  }
  return copies.back();
}

// Adds copies of the primitives of the object that begins at `face`, and returns the first face.
SurfaceId add_primitives(const Scene& part, SurfaceId face, const Placement& placement,
                         SceneAssembly& to) {
  const SurfaceId first{static_cast<std::uint32_t>(to.out.scene.surfaces.faces())};
  const ObjectId object = part.surfaces.object(face);
  for (auto begin = static_cast<std::uint32_t>(face);
       begin < part.surfaces.faces() && part.surfaces.object(SurfaceId{begin}) == object;) {
    const PrimitiveId primitive = part.surfaces.primitive(SurfaceId{begin});
    std::uint32_t end = begin;
    while (end < part.surfaces.faces() && part.surfaces.primitive(SurfaceId{end}) == primitive) {
      ++end;
    }
    to.add_primitive(placed(part.surfaces.name(primitive), placement), end - begin);
    begin = end;
  }
  return first;
}

// All meshes of an object close a volume together, each where it stands.
CsgTree::NodeId add_meshes(const Scene& part, std::span<const MeshInstance* const> meshes,
                           const Placement& placement, SceneAssembly& to, TreeAssembly& tree) {
  std::vector<TriangleMesh> moved;
  std::vector<const TriangleMesh*> pointers;
  for (const MeshInstance* mesh : meshes) {
    moved.push_back(raycat::placed(mesh->mesh->triangles, mesh->transform));
  }
  for (const TriangleMesh& mesh : moved) {
    pointers.push_back(&mesh);
  }
  TriangleMesh all = joined(pointers);
  // Meshes of several materials may be of one primitive, so faces are counted through the object.
  all.faces.clear();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::uint32_t before = distance(meshes.front()->first_face, meshes[i]->first_face);
    for (const std::uint32_t face : moved[i].faces) {
      all.faces.push_back(before + face);
    }
  }
  PlacedShape shape(std::make_shared<const ClosedMesh>(std::move(all)), Affine(placement.world));
  const SurfaceId first = to.add_primitive(
      placed(primitive_name(part, meshes.front()->first_face), placement), shape.face_count());
  tree.materials.push_back(placed(meshes.front()->material, placement));
  return tree.tree.add(CsgLeaf{.shape = std::move(shape), .first_face = first});
}

}  // namespace

std::uint32_t add_materials(const Scene& part, Scene& to) {
  const auto first = static_cast<std::uint32_t>(to.materials.size());
  const auto first_texture = static_cast<std::uint32_t>(to.textures.size());
  const auto move = [&](std::optional<TextureMap>& map) {
    if (map) {
      map->texture = TextureId{first_texture + static_cast<std::uint32_t>(map->texture)};
    }
  };
  for (Material material : part.materials) {
    move(material.base_texture);
    if (material.varying) {
      VaryingPbr varying = *material.varying;
      for (auto* map : {&varying.metallic_roughness, &varying.occlusion, &varying.emission,
                        &varying.transmission, &varying.specular, &varying.specular_colour,
                        &varying.glossiness}) {
        move(*map);
      }
      material.varying = std::make_shared<const VaryingPbr>(std::move(varying));
    }
    to.materials.push_back(std::move(material));
  }
  to.textures.insert(to.textures.end(), part.textures.begin(), part.textures.end());
  return first;
}

void place_objects(const Scene& part, const Placement& placement, SceneAssembly& to) {
  const std::vector<Parts> all = objects(part);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = part.surfaces.name(static_cast<ObjectId>(i));
    to.add_object(all.size() == 1 ? placement.name : placed(name, placement));
    if (all[i].solid) {
      TreeAssembly tree;
      add_tree(part, *all[i].solid, placement, to, tree);
      to.out.scene.solids.push_back(
          {.solid = Solid(std::move(tree.tree)), .materials = std::move(tree.materials)});
    }
    if (!all[i].meshes.empty()) {
      const SurfaceId from = all[i].meshes.front()->first_face;
      const auto first = static_cast<std::uint32_t>(add_primitives(part, from, placement, to));
      for (const MeshInstance* mesh : all[i].meshes) {
        to.out.scene.meshes.push_back(
            {.mesh = mesh->mesh,
             .transform = placed(mesh->transform, placement),
             .material = placed(mesh->material, placement),
             .first_face = SurfaceId{first + distance(from, mesh->first_face)}});
      }
    }
  }
}

std::vector<CsgTree::NodeId> place_operands(const Scene& part, const Placement& placement,
                                            SceneAssembly& to, TreeAssembly& tree) {
  std::vector<CsgTree::NodeId> operands;
  for (const Parts& object : objects(part)) {
    if (object.solid) {
      operands.push_back(add_tree(part, *object.solid, placement, to, tree));
    } else if (!object.meshes.empty()) {
      operands.push_back(add_meshes(part, object.meshes, placement, to, tree));
    }
  }
  return operands;
}

}  // namespace raycat
