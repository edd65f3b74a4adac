#include "io/export/material_json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>

namespace raycat {
namespace {

using Json = nlohmann::ordered_json;

// The shortest decimal number that is this float again.
double shortest(float value) { return std::stod(fmt::format("{}", value)); }

Json whitted_json(const Material& material) {
  Json out = Json::object();
  for (const auto& [name, colour] :
       {std::pair("emission", material.emission), std::pair("ambient", material.ambient),
        std::pair("diffuse", material.diffuse), std::pair("specular", material.specular),
        std::pair("reflection", material.reflection),
        std::pair("transmission", material.transmission)}) {
    if (colour != glm::vec3(0.0f)) {
      out[name] = colour_json(colour);
    }
  }
  out["shininess"] = shortest(material.shininess);
  out["ior"] = shortest(material.ior);
  return out;
}

// The inverse of the table in docs/materials.md, as far as there is one: mirrors are metals, what
// lets light through is smooth glass, and the rest is as rough as its highlight is wide.
Json pbr_json(const Material& material) {
  const bool mirror = glm::compMax(material.reflection) > 0.0f;
  const bool metal =
      glm::compMax(material.reflection) > 0.3f && glm::compMax(material.transmission) == 0.0f;
  const glm::vec3 base = metal ? material.reflection
                         : glm::compMax(material.transmission) > 0.0f
                             ? glm::max(material.transmission, material.diffuse)
                             : material.diffuse / 0.96f;
  const double rough = std::pow(2.0 / (static_cast<double>(material.shininess) + 2.0), 0.25);
  Json colour = colour_json(glm::clamp(base, 0.0f, 1.0f));
  colour.push_back(1.0);
  return {{"baseColorFactor", colour},
          {"metallicFactor", metal ? 1.0 : 0.0},
          {"roughnessFactor", mirror ? std::min(rough, 0.1) : rough}};
}

}  // namespace

Json colour_json(const glm::vec3& colour) {
  return {shortest(colour.r), shortest(colour.g), shortest(colour.b)};
}

Json material_json(const Material& material, std::vector<std::string>& extensions,
                   std::vector<std::string>& warnings) {
  const auto use = [&](Json& out, const char* extension, Json value) {
    out["extensions"][extension] = std::move(value);
    if (std::ranges::find(extensions, extension) == extensions.end()) {
      extensions.emplace_back(extension);
    }
  };
  Json out{{"name", material.name},
           {"doubleSided", !material.single_sided},
           {"pbrMetallicRoughness", pbr_json(material)}};
  if (glm::compMax(material.emission) > 0.0f) {
    out["emissiveFactor"] = colour_json(glm::clamp(material.emission, 0.0f, 1.0f));
  }
  if (glm::compMax(material.transmission) > 0.0f) {
    const double factor = std::min(1.0, shortest(glm::compMax(material.transmission)));
    use(out, "KHR_materials_transmission", {{"transmissionFactor", factor}});
    if (material.ior > 1.0f) {
      use(out, "KHR_materials_ior", {{"ior", shortest(material.ior)}});
    }
    if (!material.thin) {
      use(out, "KHR_materials_volume", {{"thicknessFactor", 1.0}});
    }
  }
  out["extras"] = {{"whitted", whitted_json(material)}};
  const auto lost = [&](bool is, const char* what) {
    if (is) {
      warnings.push_back(fmt::format("material '{}': {} is left out", material.name, what));
    }
  };
  lost(material.base_texture.has_value() || material.varying, "its texture");
  lost(material.absorption != glm::vec3(0.0f), "what it absorbs");
  lost(material.fresnel, "its Fresnel reflection");
  lost(material.thin && material.ior != 1.0f && glm::compMax(material.transmission) > 0.0f,
       "that it is thin");
  lost(material.blend || material.alpha_cutoff > 0.0f, "its alpha");
  return out;
}

}  // namespace raycat
