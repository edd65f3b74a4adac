#include "reference/scene_maker.hpp"

#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace raycat::reference {

double SceneMaker::between(double low, double high) {
  return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
}

glm::dvec3 SceneMaker::vec(double low, double high) {
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = between(low, high);
  }
  return result;
}

glm::dmat4 SceneMaker::bent() {
  const double angle = between(0, 6);
  glm::dmat4 m = glm::rotate(glm::dmat4(1.0), angle, vec(-1, 1) + glm::dvec3(0, 1.5, 0));
  if (below(2) == 0) {
    m = glm::scale(m, vec(0.5, 1.5));
  }
  if (below(2) == 0) {
    m[1][0] += between(-0.7, 0.7);
    m[2][1] += between(-0.7, 0.7);
  }
  return below(4) == 0 ? glm::scale(m, {-1, 1, 1}) : m;
}

void SceneMaker::name_object() {
  scene_.surfaces.add_object("object " + std::to_string(scene_.surfaces.objects()));
}

CsgLeaf SceneMaker::leaf(const Shape& shape, const glm::dmat4& transform) {
  PlacedShape placed(shape, Affine(world_ * transform));
  const SurfaceId first = scene_.surfaces.add_primitive("primitive", placed.face_count());
  return {.shape = std::move(placed), .first_face = first};
}

void SceneMaker::add_object(CsgTree tree, std::vector<MaterialId> materials) {
  scene_.solids.push_back({.solid = Solid(std::move(tree)), .materials = std::move(materials)});
}

void SceneMaker::add_solid(const Shape& shape, const glm::dmat4& transform, MaterialId material) {
  name_object();
  CsgTree tree;
  tree.add(leaf(shape, transform));
  add_object(std::move(tree), {material});
}

void SceneMaker::add_mesh(SurfaceMesh mesh, const glm::dmat4& transform, MaterialId material) {
  name_object();
  const SurfaceId first = scene_.surfaces.add_primitive("primitive", mesh.triangles.face_count);
  scene_.meshes.push_back({.mesh = std::make_shared<const SurfaceMesh>(std::move(mesh)),
                           .transform = Affine(world_ * transform),
                           .material = material,
                           .first_face = first});
}

MaterialId SceneMaker::add_material(const Material& material) {
  scene_.materials.push_back(material);
  return MaterialId{static_cast<std::uint32_t>(scene_.materials.size() - 1)};
}

void SceneMaker::add_light() {
  Light light{.kind = static_cast<Light::Kind>(below(3)),
              .position = {between(-5, 5), below(4) == 0 ? 1.0 : between(2, 6), between(-5, 6)},
              .diffuse = colour(0.2, 1),
              .specular = colour(0.2, 1),
              .inverse_square = below(2) == 0};
  light.direction =
      glm::normalize(glm::dvec3{between(-1, 1), 0.7, between(-1, 1)} - light.position);
  light.position = in_world(light.position);
  if (light.kind != Light::Kind::directional) {
    if (light.inverse_square) {
      const auto brighter = static_cast<float>(20 * scale_ * scale_);
      light.diffuse *= brighter;
      light.specular *= brighter;
    }
    if (below(2) == 0) {
      light.range = scale_ * between(4, 12);
    }
  }
  light.outer_cone = between(0.1, 0.8);
  light.inner_cone = light.outer_cone * between(0, 1);
  scene_.lights.push_back(light);
}

}  // namespace raycat::reference
