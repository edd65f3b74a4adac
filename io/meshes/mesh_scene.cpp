#include "io/meshes/mesh_scene.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "geometry/mesh_faces.hpp"
#include "io/meshes/mesh_file.hpp"

namespace raycat {

SceneFile read_mesh_scene(const std::filesystem::path& file, SceneKind kind,
                          const LoadOptions& options) {
  auto mesh = std::make_shared<SurfaceMesh>();
  MeshFile read = read_mesh_file(file, kind);
  mesh->triangles = std::move(read.triangles);
  TriangleMesh& triangles = mesh->triangles;
  MeshFaces grouped =
      group_faces(triangles.positions, triangles.triangles, {}, options.faces, options.threads);
  triangles.faces = std::move(grouped.faces);
  mesh->twins = std::move(grouped.twins);
  triangles.face_count = 1 + *std::ranges::max_element(triangles.faces);

  SceneFile out;
  if (!read.warning.empty()) {
    out.warnings.push_back(std::move(read.warning));
  }
  out.up = kind == SceneKind::stl || kind == SceneKind::off ? glm::dvec3(0.0, 0.0, 1.0)
                                                            : glm::dvec3(0.0, 1.0, 0.0);
  out.triangles = triangles.triangles.size();
  Material grey;
  grey.name = "grey";
  grey.ambient = grey.diffuse = glm::vec3(0.5f);
  grey.specular = glm::vec3(0.1f);
  grey.shininess = 20.0f;
  out.scene.materials.push_back(std::move(grey));
  const std::string name = file.stem().string();
  out.scene.surfaces.add_object(name);
  const SurfaceId first = out.scene.surfaces.add_primitive(name, triangles.face_count);
  out.scene.meshes.push_back(
      {.mesh = std::move(mesh), .transform = {}, .material = MaterialId{0}, .first_face = first});
  return out;
}

}  // namespace raycat
