#include "io/povray/material.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>

#include "io/povray/text.hpp"

namespace raycat {
namespace {

const glm::vec3 black(0.0f);

float mean(const glm::vec3& colour) { return (colour.r + colour.g + colour.b) / 3.0f; }

glm::vec3 per(const glm::vec3& colour, const glm::vec3& pigment) {
  glm::vec3 factor(0.0f);
  for (int k = 0; k < 3; ++k) {
    factor[k] = pigment[k] > 0.0f ? colour[k] / pigment[k] : 0.0f;
  }
  return factor;
}

// POV-Ray multiplies all of a surface's own light with its pigment, which is therefore nowhere
// zero where there is light of another kind than diffuse.
glm::vec3 pigment_of(const Material& material) {
  constexpr float next_to_nothing = 1e-6f;
  glm::vec3 pigment = material.diffuse;
  for (int k = 0; k < 3; ++k) {
    if (pigment[k] == 0.0f && (material.ambient[k] > 0.0f || material.emission[k] > 0.0f)) {
      pigment[k] = next_to_nothing;
    }
  }
  return pigment;
}

std::string reflection(const Material& material) {
  if (material.reflection == black) {
    return "";
  }
  return material.fresnel
             ? fmt::format(" reflection {{ {}, {} falloff 5 }} conserve_energy",
                           pov_colour(material.reflection), pov_colour(material.grazing_reflection))
             : fmt::format(" reflection {{ {} }}", pov_colour(material.reflection));
}

std::string highlight(const Material& material, float specular_ratio) {
  constexpr float least_shininess = 1e-3f;
  const float strength = material.blend ? material.alpha : 1.0f;
  return fmt::format(" specular {} roughness {}",
                     strength * specular_ratio * glm::compMax(material.specular),
                     1.0f / std::max(material.shininess, least_shininess));
}

// The surface's own light but for its highlight, and its reflection.
std::string finish(const Material& material, const glm::vec3& pigment) {
  std::string text =
      fmt::format("ambient {} diffuse 1", pov_colour(per(material.ambient, pigment)));
  if (material.emission != black) {
    text += fmt::format(" emission {}", pov_colour(per(material.emission, pigment)));
  }
  return text + reflection(material);
}

// What passes, by eq. (1)'s k_t at normal incidence; by POV-Ray's `conserve_energy` it is what
// reflection leaves of this.
glm::vec3 passing(const Material& material) {
  if (material.blend) {
    return glm::vec3(1.0f - material.alpha);
  }
  const bool conserves = material.fresnel && material.reflection != black;
  return conserves ? per(material.transmission, 1.0f - material.reflection) : material.transmission;
}

}  // namespace

float specular_to_diffuse(const std::vector<Light>& lights) {
  float diffuse = 0.0f;
  float specular = 0.0f;
  for (const Light& light : lights) {
    diffuse += mean(light.diffuse);
    specular += mean(light.specular);
  }
  return diffuse > 0.0f ? specular / diffuse : 1.0f;
}

std::string pov_texture(const Material& material, float specular_ratio) {
  const glm::vec3 passes = passing(material);
  const bool shines = material.specular != black;
  const bool grey = material.specular == glm::vec3(material.specular.r);
  const glm::vec3 own = pigment_of(material);
  const glm::vec3 pigment = material.blend ? material.alpha * own : own;
  const std::string surface =
      finish(material, own) + (shines && grey ? highlight(material, specular_ratio) : "");
  std::string text;
  if (passes == black) {
    text =
        fmt::format("texture {{ pigment {{ {} }} finish {{ {} }} }}", pov_colour(pigment), surface);
  } else {
    // In POV-Ray the more a surface lets through, the less of its own light is seen. So that has a
    // layer of its own, which halves both, over one that only colours what passes. The upper layer
    // comes last.
    text = fmt::format(
        "texture {{ pigment {{ {} filter 1 }} finish {{ ambient 0 diffuse 0 }} }}\n"
        "texture {{ pigment {{ {} transmit 0.5 }} finish {{ {} }} }}",
        pov_colour(2.0f * passes), pov_colour(2.0f * pigment), surface);
  }
  if (shines && !grey) {
    text += fmt::format(
        "\ntexture {{ pigment {{ {} transmit 1 }} finish {{ ambient 0 diffuse 0{} metallic }} }}",
        pov_colour(material.specular / glm::compMax(material.specular)),
        highlight(material, specular_ratio));
  }
  return text;
}

std::string pov_interior(const Material& material) {
  return material.transmission == black || material.thin || material.ior == 1.0f
             ? ""
             : fmt::format(" interior {{ ior {} }}", material.ior);
}

}  // namespace raycat
