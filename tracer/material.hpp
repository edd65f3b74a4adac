#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "tracer/pbr.hpp"
#include "tracer/texture_place.hpp"

namespace raycat {

enum class MaterialId : std::uint32_t {};
enum class TextureId : std::uint32_t {};

/// A texture on a surface.
struct TextureMap {
  TextureId texture{};
  TexturePlace place;
};

/// PBR parameters that vary over a surface: each is its factor times its texture, in the channels
/// that glTF gives them.
struct VaryingPbr {
  Pbr factors;
  std::optional<TextureMap> metallic_roughness;  ///< roughness in green, metallic in blue
  std::optional<TextureMap> occlusion;           ///< in red
  double occlusion_strength = 1.0;
  std::optional<TextureMap> emission;
  std::optional<TextureMap> transmission;  ///< in red
  std::optional<TextureMap> specular;      ///< in alpha
  std::optional<TextureMap> specular_colour;
  std::optional<TextureMap> glossiness;  ///< one less roughness, in alpha
};

/// The constants of eq. (1), linear RGB. k_s and k_t have a colour, since metals and glass do.
struct Material {
  std::string name;
  glm::vec3 emission{0.0f};      ///< O_e
  glm::vec3 ambient{0.0f};       ///< O_a
  glm::vec3 diffuse{0.0f};       ///< O_d
  glm::vec3 specular{0.0f};      ///< O_s
  float shininess = 1.0f;        ///< n
  glm::vec3 reflection{0.0f};    ///< k_s; a reflected ray exists where it is not zero
  glm::vec3 transmission{0.0f};  ///< k_t; a refracted ray exists where it is not zero
  float ior = 1.0f;              ///< index of refraction of the inside
  bool thin = false;             ///< rays pass straight through, whatever the ior
  glm::vec3 absorption{0.0f};  ///< light that goes d through the inside is times exp(-absorption d)

  /// Dielectrics from glTF: k_s grows to `grazing_reflection` at grazing angles and k_t falls to
  /// zero, by Schlick's approximation. Never decides whether a ray exists.
  bool fresnel = false;
  glm::vec3 grazing_reflection{0.0f};

  /// Multiplies ambient, diffuse and (`textured_emission`) emission, as vertex colours do. Its
  /// alpha never decides whether a ray is spawned, only how much it weighs.
  std::optional<TextureMap> base_texture;
  bool textured_emission = false;  ///< unlit: the base colour is the emission

  /// Where the constants vary in more than that: what they are made of at each point (see
  /// `material_at`). Those above then are what the factors alone make, and decide which rays exist.
  std::shared_ptr<const VaryingPbr> varying;

  /// alphaMode BLEND: the texture's and vertices' alpha times `alpha` covers, the rest is seen
  /// straight through. `thin` is set, and `transmission` is what the factors alone let pass, or
  /// one where a texture or the vertices have alpha of their own.
  bool blend = false;
  float alpha = 1.0f;
  /// alphaMode MASK: where alpha is below, there is no surface. 0 is no mask.
  float alpha_cutoff = 0.0f;

  /// Meshes are seen from outside alone: rays that look for what is seen pass their back faces,
  /// shadow rays do not. Solids have no back faces. Only of what lets no light through.
  bool single_sided = false;
};

}  // namespace raycat
