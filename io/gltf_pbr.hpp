#pragma once

#include <glm/vec3.hpp>

#include "tracer/material.hpp"

namespace raycat {

/// The factors of glTF 2.0 and its material extensions, as far as the paper's constants can show
/// them; what a material does not say is what they default to.
struct Pbr {
  glm::dvec3 base{1.0};
  double alpha = 1.0;  ///< for `alphaMode`, which is not of the table
  double metallic = 1.0;
  double roughness = 1.0;
  glm::dvec3 emission{0.0};
  double ior = 1.5;
  double specular = 1.0;
  glm::dvec3 specular_colour{1.0};
  double transmission = 0.0;
  bool thin = true;  ///< without thickness
  bool unlit = false;
};

/// The constants of eq. (1) for a surface of these factors, by the table of DESIGN 9.
Material whitted(const Pbr& pbr);

}  // namespace raycat
