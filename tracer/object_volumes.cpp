#include "tracer/object_volumes.hpp"

#include <map>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "geometry/joined_mesh.hpp"

namespace raycat {
namespace {

using Parts = std::vector<const MeshInstance*>;

// The primitives of a mesh, for telling apart what is placed many times.
using Key = std::vector<const SurfaceMesh*>;

bool placed_alike(const Parts& parts) {
  for (const MeshInstance* part : parts) {
    if (part->transform.matrix() != parts.front()->transform.matrix()) {
      return false;
    }
  }
  return true;
}

// All triangles as one mesh of one face, in the parts' own frame or in the world.
TriangleMesh one_face(const Parts& parts, bool in_world) {
  TriangleMesh all;
  for (const MeshInstance* part : parts) {
    const TriangleMesh& mesh = part->mesh->triangles;
    append(all, in_world ? placed(mesh, part->transform) : mesh, 0);
  }
  all.faces.assign(all.triangles.size(), 0);
  all.face_count = 1;
  return all;
}

std::shared_ptr<const Solid> lone(Shape shape, const Affine& transform) {
  CsgTree tree;
  tree.add(CsgLeaf{.shape = PlacedShape(std::move(shape), transform)});
  return std::make_shared<const Solid>(std::move(tree));
}

void measure_surface(const Parts& parts, ObjectVolume& out) {
  const TriangleMesh mesh = one_face(parts, true);
  out.open_bounds = bounds(mesh);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3& corner = mesh.positions[t.x];
    out.open_area +=
        0.5 * glm::length(glm::cross(mesh.positions[t.y] - corner, mesh.positions[t.z] - corner));
  }
}

// What a mesh comes to wherever it is placed.
struct Closed {
  MeshShape shape;
  std::string problem;
};

Closed close(const Parts& parts, bool in_world) {
  try {
    return {.shape = std::make_shared<const ClosedMesh>(one_face(parts, in_world))};
  } catch (const std::invalid_argument& error) {
    return {.problem = error.what()};
  }
}

}  // namespace

std::vector<ObjectVolume> object_volumes(const Scene& scene) {
  const auto index = [&](SurfaceId face) {
    return static_cast<std::size_t>(scene.surfaces.object(face));
  };
  std::vector<ObjectVolume> out(scene.surfaces.objects());
  for (const SolidObject& object : scene.solids) {
    ObjectVolume& volume = out[index(object.solid.tree().leaves().front().first_face)];
    if (object.solid.bounds().empty() || object.solid.bounds().finite()) {
      volume.solid = {std::shared_ptr<const void>(), &object.solid};  // the scene owns it
    } else {
      volume.problem = "a half-space leaves it unbounded";
    }
  }
  std::map<std::size_t, Parts> meshes;
  for (const MeshInstance& instance : scene.meshes) {
    meshes[index(instance.first_face)].push_back(&instance);
  }
  std::map<Key, Closed> shared;
  for (const auto& [object, parts] : meshes) {
    const bool alike = placed_alike(parts);
    Closed closed;
    if (alike) {
      Key key;
      for (const MeshInstance* part : parts) {
        key.push_back(part->mesh.get());
      }
      const auto [place, is_new] = shared.try_emplace(std::move(key));
      if (is_new) {
        place->second = close(parts, false);
      }
      closed = place->second;
    } else {
      closed = close(parts, true);
    }
    out[object].problem = closed.problem;
    if (closed.shape != nullptr) {
      out[object].solid = lone(closed.shape, alike ? parts.front()->transform : Affine());
    } else {
      measure_surface(parts, out[object]);
    }
  }
  return out;
}

}  // namespace raycat
