#include "render/textured_primitives.hpp"

namespace raycat {

std::vector<bool> textured_primitives(const Scene& scene) {
  std::vector<bool> textured;
  for (const MeshInstance& instance : scene.meshes) {
    const Material& material = scene.materials[static_cast<std::size_t>(instance.material)];
    if (material.base_texture || material.varying) {
      textured.resize(scene.surfaces.primitives());
      textured[static_cast<std::size_t>(scene.surfaces.primitive(instance.first_face))] = true;
    }
  }
  return textured;
}

}  // namespace raycat
