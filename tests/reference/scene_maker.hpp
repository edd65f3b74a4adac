#pragma once

#include <random>
#include <vector>

#include <glm/mat4x4.hpp>

#include "geometry/mesh.hpp"
#include "tracer/scene.hpp"

namespace raycat::reference {

/// Draws random numbers and puts together a scene of them, the same of the same seed.
class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

 protected:
  unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
  double between(double low, double high);
  glm::dvec3 vec(double low, double high);
  glm::vec3 colour(double low, double high) { return glm::vec3(vec(low, high)); }

  /// A turn, most often with a stretch, a shear or a mirror.
  glm::dmat4 bent();

  void name_object();
  CsgLeaf leaf(const Shape& shape, const glm::dmat4& transform);
  void add_object(CsgTree tree, std::vector<MaterialId> materials);
  void add_solid(const Shape& shape, const glm::dmat4& transform, MaterialId material);
  void add_mesh(SurfaceMesh mesh, const glm::dmat4& transform, MaterialId material);
  void add_light();

  glm::dvec3 in_world(const glm::dvec3& point) const {
    return glm::dvec3(world_ * glm::dvec4(point, 1.0));
  }

  MaterialId add_material(const Material& material);
  const Material& material_of(MaterialId id) const {
    return scene_.materials[static_cast<std::size_t>(id)];
  }

  double scale_ = 1.0;     ///< of the world
  glm::dmat4 world_{1.0};  ///< that all which is added is put into
  Scene scene_;

 private:
  std::mt19937 random_;
};

}  // namespace raycat::reference
