#include "tracer/pbr.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "tracer/material.hpp"

namespace raycat {
namespace {

constexpr double mirror_roughness = 0.3;  // rougher surfaces have no mirror image

double greatest(const glm::dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

}  // namespace

Material whitted(const Pbr& pbr) {
  const double r = pbr.roughness;
  const double m = pbr.metallic;
  const double index_ratio = (pbr.ior - 1.0) / (pbr.ior + 1.0);
  const glm::dvec3 dielectric =
      glm::min(index_ratio * index_ratio * pbr.specular_colour, glm::dvec3(1.0)) * pbr.specular;
  const glm::dvec3 f0 = glm::mix(dielectric, pbr.base, m);
  const double sharpness = r <= mirror_roughness ? 1.0 - r / mirror_roughness : 0.0;
  const double n = std::clamp(2.0 / std::pow(std::max(r, 1e-3), 4.0) - 2.0, 1.0, 1024.0);

  Material material;
  material.emission = glm::vec3(pbr.emission);
  if (pbr.unlit) {
    material.emission = glm::vec3(pbr.base);
    material.textured_emission = true;
    return material;
  }
  material.diffuse =
      glm::vec3(pbr.base * (1.0 - m) * (1.0 - pbr.transmission) * (1.0 - greatest(dielectric)));
  material.ambient = material.diffuse * static_cast<float>(pbr.occlusion);
  material.specular = glm::vec3(glm::min(f0 * (n + 8.0) / 8.0, glm::dvec3(1.0)));
  material.shininess = static_cast<float>(n);
  material.reflection = glm::vec3(f0 * sharpness);
  material.transmission =
      glm::vec3(pbr.transmission * (1.0 - m) * (glm::dvec3(1.0) - f0) * pbr.base);
  material.ior = static_cast<float>(pbr.ior);
  material.thin = pbr.thin;
  if (!pbr.thin && pbr.attenuation_distance > 0.0) {
    constexpr double darkest = 1e-30;  // of which the logarithm still is a number
    material.absorption =
        glm::vec3(-glm::log(glm::max(pbr.attenuation_colour, darkest)) / pbr.attenuation_distance);
  }
  if (pbr.transmission > 0.0 && r <= mirror_roughness) {
    material.fresnel = true;
    material.grazing_reflection = glm::vec3(static_cast<float>(sharpness));
  }
  return material;
}

}  // namespace raycat
