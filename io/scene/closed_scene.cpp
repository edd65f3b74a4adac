#include "io/scene/closed_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "geometry/closed_edges.hpp"
#include "geometry/weld.hpp"

namespace raycat {
namespace {

bool encloses_volume(const std::vector<const MeshInstance*>& instances) {
  // Where all are placed alike they are looked at before that, since it rounds.
  const Affine& first_place = instances.front()->transform;
  const bool alike = std::ranges::all_of(instances, [&](const MeshInstance* instance) {
    return instance->transform.matrix() == first_place.matrix();
  });
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;
  for (const MeshInstance* instance : instances) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    const TriangleMesh& from = instance->mesh->triangles;
    for (const glm::dvec3& position : from.positions) {
      positions.push_back(alike ? position : instance->transform.point(position));
    }
    for (const glm::uvec3& triangle : from.triangles) {
      triangles.push_back(triangle + first);
    }
  }
  const std::vector<std::uint32_t> same = weld(positions);
  for (glm::uvec3& triangle : triangles) {
    triangle = {same[triangle.x], same[triangle.y], same[triangle.z]};
  }
  return !triangles.empty() && edge_balance(positions, triangles).bad == 0;
}

}  // namespace

bool is_closed(const Scene& scene) {
  std::map<ObjectId, std::vector<const MeshInstance*>> objects;
  for (const MeshInstance& instance : scene.meshes) {
    objects[scene.surfaces.object(instance.first_face)].push_back(&instance);
  }
  return scene.surfaces.objects() > 0 && std::ranges::all_of(objects, [](const auto& object) {
           return encloses_volume(object.second);
         });
}

}  // namespace raycat
