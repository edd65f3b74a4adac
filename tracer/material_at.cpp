#include "tracer/material_at.hpp"

#include <optional>

#include <glm/common.hpp>

namespace raycat {
namespace {

const Texture& texture_of(const Scene& scene, const TextureMap& map) {
  return scene.textures[static_cast<std::size_t>(map.texture)];
}

// What no image tells, for want of coordinates, the factors do.
glm::vec4 colour(const Scene& scene, const std::optional<TextureMap>& map, const MeshPoint& point) {
  const auto at = map ? point.on(map->place) : std::nullopt;
  return at ? texture_of(scene, *map).sample(*at) : glm::vec4(1.0f);
}

glm::dvec4 numbers(const Scene& scene, const std::optional<TextureMap>& map,
                   const MeshPoint& point) {
  const auto at = map ? point.on(map->place) : std::nullopt;
  return at ? glm::dvec4(texture_of(scene, *map).sample_numbers(*at)) : glm::dvec4(1.0);
}

}  // namespace

glm::vec4 base_colour(const Scene& scene, const Material& material, const MeshPoint& point) {
  return point.colour() * colour(scene, material.base_texture, point);
}

Material material_at(const Scene& scene, const VaryingPbr& varying, const MeshPoint& point,
                     const glm::vec4& base) {
  Pbr pbr = varying.factors;
  pbr.base = glm::min(pbr.base * glm::dvec3(base), 1.0);
  const glm::dvec4 rough_metal = numbers(scene, varying.metallic_roughness, point);
  pbr.roughness *= rough_metal.g;
  pbr.metallic *= rough_metal.b;
  const double glossiness = numbers(scene, varying.glossiness, point).a;
  pbr.roughness = 1.0 - (1.0 - pbr.roughness) * glossiness;
  pbr.occlusion =
      1.0 + varying.occlusion_strength * (numbers(scene, varying.occlusion, point).r - 1.0);
  pbr.emission *= glm::dvec3(colour(scene, varying.emission, point));
  pbr.transmission *= numbers(scene, varying.transmission, point).r;
  pbr.specular *= numbers(scene, varying.specular, point).a;
  pbr.specular_colour *= glm::dvec3(colour(scene, varying.specular_colour, point));
  return whitted(pbr);
}

glm::vec3 transmission(const Scene& scene, const Material& material, const MeshPoint& point,
                       const glm::vec4& base) {
  if (material.blend) {
    return glm::vec3(1.0f - glm::min(1.0f, material.alpha * base.a));
  }
  return material.varying && material.transmission != glm::vec3(0.0f)
             ? material_at(scene, *material.varying, point, base).transmission
             : material.transmission;
}

}  // namespace raycat
