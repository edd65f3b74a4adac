#pragma once

#include <limits>
#include <string>

#include <glm/vec3.hpp>

namespace raycat {

/// Which lights count as those that reach a surface.
enum class CountedLights {
  lighting,  ///< visible ones, where the material's factors let them contribute to eq. (1)
  visible    ///< all visible ones, as the paper has it
};

/// A light source of eq. (1): L_d and L_s are linear RGB.
struct Light {
  enum class Kind { point, directional, spot };

  std::string name;
  Kind kind = Kind::point;
  glm::dvec3 position{0.0};              ///< of point lights and spots
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit, the way the light travels
  glm::vec3 diffuse{1.0f};               ///< L_d
  glm::vec3 specular{1.0f};              ///< L_s

  /// glTF's lights fall off with the square of the distance; the paper's do not.
  bool inverse_square = false;
  /// Distance past which a point light or spot has no effect (KHR_lights_punctual).
  double range = std::numeric_limits<double>::infinity();
  double inner_cone = 0.0;                 ///< radians from the axis; full strength within
  double outer_cone = 0.7853981633974483;  ///< radians from the axis; no light beyond
};

}  // namespace raycat
