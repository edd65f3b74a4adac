#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "tracer/scene.hpp"

namespace raycat {

/// Builds small scenes for tests, object by object.
class SceneBuilder {
 public:
  MaterialId material(Material material) {
    scene_.materials.push_back(std::move(material));
    return MaterialId{static_cast<std::uint32_t>(scene_.materials.size() - 1)};
  }

  /// A lone shape.
  SceneBuilder& shape(const std::string& name, const Shape& shape, const glm::dmat4& transform,
                      MaterialId material) {
    CsgTree tree;
    tree.add(leaf(name, shape, transform, true));
    scene_.solids.push_back({.solid = Solid(std::move(tree)), .materials = {material}});
    return *this;
  }

  /// Two shapes under an operation.
  SceneBuilder& pair(const std::string& name, Operation operation, const Shape& a,
                     const glm::dmat4& a_transform, const Shape& b, const glm::dmat4& b_transform,
                     MaterialId material) {
    CsgTree tree;
    const std::array operands{tree.add(leaf(name, a, a_transform, true)),
                              tree.add(leaf(name + " tool", b, b_transform, false))};
    tree.add(operation, operands);
    scene_.solids.push_back({.solid = Solid(std::move(tree)), .materials = {material, material}});
    return *this;
  }

  SceneBuilder& mesh(const std::string& name, SurfaceMesh mesh, const glm::dmat4& transform,
                     MaterialId material) {
    scene_.surfaces.add_object(name);
    const SurfaceId first = scene_.surfaces.add_primitive(name, mesh.triangles.face_count);
    scene_.meshes.push_back({.mesh = std::make_shared<const SurfaceMesh>(std::move(mesh)),
                             .transform = Affine(transform),
                             .material = material,
                             .first_face = first});
    return *this;
  }

  SceneBuilder& light(Light light) {
    scene_.lights.push_back(std::move(light));
    return *this;
  }

  Scene take() { return std::move(scene_); }

 private:
  CsgLeaf leaf(const std::string& name, const Shape& shape, const glm::dmat4& transform,
               bool object) {
    if (object) {
      scene_.surfaces.add_object(name);
    }
    PlacedShape placed(shape, Affine(transform));
    const SurfaceId first = scene_.surfaces.add_primitive(name, placed.face_count());
    return {.shape = std::move(placed), .first_face = first};
  }

  Scene scene_;
};

inline glm::dmat4 at(double x, double y, double z) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

/// Two triangles, z = 0, from -half to half, seen from +z; one face.
inline SurfaceMesh square(double half) {
  SurfaceMesh mesh;
  mesh.triangles.positions = {
      {-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.triangles.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangles.faces = {0, 0};
  mesh.triangles.face_count = 1;
  mesh.texture_coordinates = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  return mesh;
}

}  // namespace raycat
