#pragma once

#include <glm/vec3.hpp>

namespace raycat {

struct Material;

/// The parameters of glTF 2.0's metallic-roughness model and of the material extensions, as far as
/// the paper's constants can show them; what a material does not say is what they default to.
struct Pbr {
  glm::dvec3 base{1.0};
  double alpha = 1.0;  ///< for `alphaMode`, which is not of the table
  double metallic = 1.0;
  double roughness = 1.0;
  double occlusion = 1.0;
  glm::dvec3 emission{0.0};
  double ior = 1.5;
  double specular = 1.0;
  glm::dvec3 specular_colour{1.0};
  double transmission = 0.0;
  glm::dvec3 attenuation_colour{1.0};
  double attenuation_distance = 0.0;  ///< 0 stands for infinite
  bool thin = true;                   ///< without thickness
  bool unlit = false;
};

/// The constants of eq. (1) for a surface of these parameters, by the table of docs/materials.md.
Material whitted(const Pbr& pbr);

}  // namespace raycat
