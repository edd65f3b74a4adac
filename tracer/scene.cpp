#include "tracer/scene.hpp"

namespace raycat {

Bounds bounds(const Scene& scene) {
  Bounds all;
  for (const SolidObject& object : scene.solids) {
    if (!object.solid.bounds().empty() && object.solid.bounds().finite()) {
      all.include(object.solid.bounds());
    }
  }
  for (const MeshInstance& instance : scene.meshes) {
    for (const glm::dvec3& position : instance.mesh->triangles.positions) {
      all.include(instance.transform.point(position));
    }
  }
  return all;
}

}  // namespace raycat
