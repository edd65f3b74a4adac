#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "csg/solid.hpp"
#include "geometry/placed_shape.hpp"
#include "raytree/surface_table.hpp"
#include "tracer/camera.hpp"
#include "tracer/light.hpp"
#include "tracer/material.hpp"
#include "tracer/surface_mesh.hpp"
#include "tracer/texture.hpp"

namespace raycat {

/// A mesh that is seen as it is, open or closed: one glTF primitive placed by one node.
struct MeshInstance {
  std::shared_ptr<const SurfaceMesh> mesh;
  Affine transform;
  MaterialId material{};
  SurfaceId first_face{};
};

/// A lone shape or a CSG tree.
struct SolidObject {
  Solid solid;
  std::vector<MaterialId> materials;  ///< one a leaf
};

/// All that is seen, lit and looked from. Does not change once built.
struct Scene {
  SurfaceTable surfaces;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<MeshInstance> meshes;
  std::vector<SolidObject> solids;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  glm::vec3 background{0.8f, 0.85f, 0.9f};
  glm::vec3 ambient_light{0.2f};                           ///< S_a
  CountedLights counted_lights = CountedLights::lighting;  ///< by the nodes of ray trees
};

inline const Material& material_of(const Scene& scene, MaterialId id) {
  return scene.materials[static_cast<std::size_t>(id)];
}

/// Around everything that is bounded; empty for a scene without bounded objects.
Bounds bounds(const Scene& scene);

}  // namespace raycat
