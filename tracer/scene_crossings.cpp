#include "tracer/scene_crossings.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

#include "geometry/triangle_index.hpp"

namespace raycat {
namespace {

std::uint32_t face(const SurfaceMesh& mesh, const Crossing& crossing, const Ray& local) {
  if (!mesh.features) {
    return crossing.face;
  }
  const glm::uvec3 i = mesh.triangles.triangles[crossing.face];
  const auto& positions = mesh.triangles.positions;
  const glm::dvec3 ab = positions[i.y] - positions[i.x];
  const glm::dvec3 ac = positions[i.z] - positions[i.x];
  const glm::dvec3 ap = local.at(crossing.t) - positions[i.x];
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area = glm::dot(normal, normal);
  return MeshPoint{.mesh = mesh,
                   .triangle = crossing.face,
                   .barycentric = {glm::dot(glm::cross(ap, ac), normal) / area,
                                   glm::dot(glm::cross(ab, ap), normal) / area}}
      .face();
}

}  // namespace

// Crossings of a mesh know their face; where an image tells faces they must know their triangle.
struct SceneCrossings::Indexed {
  explicit Indexed(const SurfaceMesh& mesh)
      : counted(mesh.features ? mesh.triangles : TriangleMesh()),
        index(mesh.features ? counted : mesh.triangles) {
    std::iota(counted.faces.begin(), counted.faces.end(), std::uint32_t{0});
  }

  TriangleMesh counted;  // each triangle a face, if it is needed
  TriangleIndex index;
};

SceneCrossings::SceneCrossings(const Scene& scene) : scene_(scene) {
  std::map<const SurfaceMesh*, std::shared_ptr<const Indexed>> shared;
  for (const MeshInstance& instance : scene.meshes) {
    auto& mesh = shared[instance.mesh.get()];
    if (!mesh) {
      mesh = std::make_shared<const Indexed>(*instance.mesh);
    }
    meshes_.push_back(mesh);
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
    const Ray local = instance.transform.to_local(ray);
    meshes_[i]->index.cross(local, crossings);
    for (const Crossing& crossing : crossings) {
      out.push_back({.t = crossing.t,
                     .surface = SurfaceId{static_cast<std::uint32_t>(instance.first_face) +
                                          face(*instance.mesh, crossing, local)},
                     .entering = crossing.entering,
                     .normal = instance.transform.normal(crossing.normal)});
    }
  }
  std::ranges::stable_sort(out, {}, &SceneCrossing::t);
}

}  // namespace raycat
