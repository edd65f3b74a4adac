#include "tracer/scene_crossings.hpp"

#include <algorithm>
#include <map>

namespace raycat {

SceneCrossings::SceneCrossings(const Scene& scene) : scene_(scene) {
  std::map<const SurfaceMesh*, std::shared_ptr<const TriangleIndex>> shared;
  for (const MeshInstance& instance : scene.meshes) {
    auto& index = shared[instance.mesh.get()];
    if (!index) {
      index = std::make_shared<TriangleIndex>(instance.mesh->triangles);
    }
    meshes_.push_back(index);
  }
}

void SceneCrossings::cross(const Ray& ray, Solid::Scratch& scratch,
                           std::vector<SceneCrossing>& out) const {
  out.clear();
  for (const SolidObject& object : scene_.solids) {
    object.solid.cross(ray, scratch);
    for (const Boundary& boundary : scratch.boundaries) {
      out.push_back({.t = boundary.t,
                     .surface = object.solid.surface(boundary),
                     .entering = boundary.entering,
                     .normal = object.solid.normal(boundary)});
    }
  }
  Crossings crossings;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const MeshInstance& instance = scene_.meshes[i];
    crossings.clear();
    meshes_[i]->cross(instance.transform.to_local(ray), crossings);
    for (const Crossing& crossing : crossings) {
      out.push_back(
          {.t = crossing.t,
           .surface = SurfaceId{static_cast<std::uint32_t>(instance.first_face) + crossing.face},
           .entering = crossing.entering,
           .normal = instance.transform.normal(crossing.normal)});
    }
  }
  std::ranges::stable_sort(out, {}, &SceneCrossing::t);
}

}  // namespace raycat
