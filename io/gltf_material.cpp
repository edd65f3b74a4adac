#include "io/gltf_material.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/excerpt.hpp"
#include "io/gltf_pbr.hpp"
#include "io/scene_file.hpp"

namespace raycat {
namespace {

// Each factor must lie where the table's formulas mean something.
double in_range(const JsonFields& fields, const char* name, double value, double least,
                double most) {
  if (!(value >= least && value <= most)) {
    fields.fail(fmt::format("{} must be from {} to {}, but is {}", name, least, most, value));
  }
  return value;
}

// Some exporters write 255 for 1, and the rest of the file is still worth seeing: glTF's own
// factors are brought into range with a warning. Ours are refused.
class Limits {
 public:
  Limits(std::vector<std::string>& warnings, const std::string& place)
      : warnings_(warnings), place_(place) {}

  double operator()(const char* name, double value, double least, double most) const {
    if (value >= least && value <= most) {
      return value;
    }
    const double limited = std::clamp(value, least, most);
    warnings_.push_back(fmt::format("{}: {} must be from {} to {}, but is {}; {} is used", place_,
                                    name, least, most, value, limited));
    return limited;
  }

  glm::dvec3 operator()(const char* name, glm::dvec3 value, double least, double most) const {
    for (int c = 0; c < 3; ++c) {
      value[c] = (*this)(name, value[c], least, most);
    }
    return value;
  }

 private:
  std::vector<std::string>& warnings_;
  const std::string& place_;
};

constexpr double any = 1e6;
constexpr std::size_t max_coordinates = 1000;

void read_extensions(const GltfDocument& document, const nlohmann::json& json,
                     const std::string& place, const Limits& limit, Pbr& pbr) {
  if (auto fields = document.extension(json, "KHR_materials_emissive_strength", place)) {
    pbr.emission *=
        limit("emissiveStrength", fields->number("emissiveStrength").value_or(1.0), 0.0, any);
  }
  if (auto fields = document.extension(json, "KHR_materials_ior", place)) {
    const double ior = fields->number("ior").value_or(1.5);
    // 0 stands for an infinite index, in files converted from specular-glossiness.
    pbr.ior = ior == 0.0 ? any : limit("ior", ior, 1.0, any);
  }
  if (auto fields = document.extension(json, "KHR_materials_specular", place)) {
    pbr.specular =
        limit("specularFactor", fields->number("specularFactor").value_or(1.0), 0.0, 1.0);
    pbr.specular_colour =
        limit("specularColorFactor",
              fields->vector("specularColorFactor").value_or(glm::dvec3(1.0)), 0.0, any);
  }
  if (auto fields = document.extension(json, "KHR_materials_transmission", place)) {
    pbr.transmission =
        limit("transmissionFactor", fields->number("transmissionFactor").value_or(0.0), 0.0, 1.0);
  }
  if (auto fields = document.extension(json, "KHR_materials_volume", place)) {
    pbr.thin = !(fields->number("thicknessFactor").value_or(0.0) > 0.0);
  }
  pbr.unlit = document.extension(json, "KHR_materials_unlit", place).has_value();
}

Pbr read_pbr(const tinygltf::Material& from, const Limits& limit) {
  const auto& factors = from.pbrMetallicRoughness;
  const auto& base = factors.baseColorFactor;
  const auto& emission = from.emissiveFactor;
  return {.base = limit("baseColorFactor", glm::dvec3(base[0], base[1], base[2]), 0.0, 1.0),
          .alpha = limit("baseColorFactor", base[3], 0.0, 1.0),
          .metallic = limit("metallicFactor", factors.metallicFactor, 0.0, 1.0),
          .roughness = limit("roughnessFactor", factors.roughnessFactor, 0.0, 1.0),
          .emission =
              limit("emissiveFactor", glm::dvec3(emission[0], emission[1], emission[2]), 0.0, any)};
}

// The older specular-glossiness model: the same surface with F0 given outright.
void read_glossiness(JsonFields& fields, const Limits& limit, Pbr& pbr) {
  const auto diffuse = fields.vector4("diffuseFactor").value_or(glm::dvec4(1.0));
  pbr.base = limit("diffuseFactor", glm::dvec3(diffuse), 0.0, 1.0);
  pbr.alpha = limit("diffuseFactor", diffuse.w, 0.0, 1.0);
  pbr.metallic = 0.0;
  pbr.roughness =
      1.0 - limit("glossinessFactor", fields.number("glossinessFactor").value_or(1.0), 0.0, 1.0);
  // The table scales ((ior - 1) / (ior + 1))^2, which an infinite ior makes 1.
  pbr.ior = any;
  pbr.specular_colour =
      limit("specularFactor", fields.vector("specularFactor").value_or(glm::dvec3(1.0)), 0.0, 1.0);
}

Material whitted_extras(JsonFields fields, Material material) {
  const auto set = [](glm::vec3& constant, const std::optional<glm::dvec3>& value) {
    constant = glm::vec3(value.value_or(glm::dvec3(0.0)));
  };
  set(material.emission, fields.vector("emission"));
  set(material.ambient, fields.vector("ambient"));
  set(material.diffuse, fields.vector("diffuse"));
  set(material.specular, fields.vector("specular"));
  material.shininess = static_cast<float>(
      in_range(fields, "shininess", fields.number("shininess").value_or(1.0), 0.0, any));
  set(material.reflection, fields.number_or_vector("reflection"));
  set(material.transmission, fields.number_or_vector("transmission"));
  material.ior =
      static_cast<float>(in_range(fields, "ior", fields.number("ior").value_or(1.0), 1e-3, any));
  fields.refuse_others();
  for (const auto& [name, colour] :
       {std::pair("emission", material.emission), std::pair("ambient", material.ambient),
        std::pair("diffuse", material.diffuse), std::pair("specular", material.specular),
        std::pair("reflection", material.reflection),
        std::pair("transmission", material.transmission)}) {
    for (int c = 0; c < 3; ++c) {
      in_range(fields, name, static_cast<double>(colour[c]), 0.0, any);
    }
  }
  return material;
}

void read_texture(JsonFields& info, std::size_t textures, GltfMaterial& to) {
  to.texture = info.index("index", "textures", textures);
  to.coordinates = info.index("texCoord", "TEXCOORD", max_coordinates).value_or(0);
  auto extensions = info.object("extensions");
  auto transform = extensions ? extensions->object("KHR_texture_transform") : std::nullopt;
  if (!transform) {
    return;
  }
  const auto offset = transform->vector2("offset").value_or(glm::dvec2(0.0));
  const auto scale = transform->vector2("scale").value_or(glm::dvec2(1.0));
  const double angle = transform->number("rotation").value_or(0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  to.texture_transform = {c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x, offset.y};
  to.coordinates =
      transform->index("texCoord", "TEXCOORD", max_coordinates).value_or(to.coordinates);
}

void read_alpha(const tinygltf::Material& from, const JsonFields& fields, const Limits& limit,
                const Pbr& pbr, Material& to) {
  if (from.alphaMode == "BLEND") {
    to.blend = true;
    to.alpha = static_cast<float>(pbr.alpha);
    to.thin = true;
    to.transmission = glm::vec3(1.0f - to.alpha);
    to.fresnel = false;
  } else if (from.alphaMode == "MASK") {
    to.alpha = static_cast<float>(pbr.alpha);
    to.alpha_cutoff = static_cast<float>(limit("alphaCutoff", from.alphaCutoff, 0.0, any));
  } else if (from.alphaMode != "OPAQUE") {
    fields.fail(fmt::format("alphaMode: unknown mode '{}'; expected OPAQUE, MASK or BLEND",
                            excerpt(from.alphaMode)));
  }
}

GltfMaterial read_material(GltfDocument& document, std::size_t number) {
  const tinygltf::Material& from = document.model.materials[number];
  const auto& json = document.json["materials"][number];
  const std::string place = from.name.empty()
                                ? fmt::format("materials[{}]", number)
                                : fmt::format("materials[{}] '{}'", number, excerpt(from.name));
  const Limits limit(document.warnings, place);
  Pbr pbr = read_pbr(from, limit);
  read_extensions(document, json, place, limit, pbr);
  GltfMaterial to;
  const std::size_t textures = document.model.textures.size();
  std::optional<JsonFields> texture;
  if (auto factors = JsonFields(document.file, place, "", json).object("pbrMetallicRoughness")) {
    texture = factors->object("baseColorTexture");
  }
  if (auto fields = document.extension(json, "KHR_materials_pbrSpecularGlossiness", place)) {
    read_glossiness(*fields, limit, pbr);
    texture = fields->object("diffuseTexture");
  }
  to.material = whitted(pbr);
  to.material.name = from.name;
  read_alpha(from, JsonFields(document.file, place, "", json), limit, pbr, to.material);
  if (texture) {
    read_texture(*texture, textures, to);
  }
  if (const auto extras = json.find("extras"); extras != json.end() && extras->is_object()) {
    JsonFields fields(document.file, place, "extras", *extras);
    if (auto constants = fields.object("whitted")) {
      Material outright;
      outright.name = from.name;
      to.material = whitted_extras(*std::move(constants), outright);
      fields.refuse_others();
    }
  }
  return to;
}

// Which materials are on a primitive whose vertices have colours of their own?
std::vector<bool> with_vertex_colours(const tinygltf::Model& model) {
  std::vector<bool> coloured(model.materials.size());
  for (const tinygltf::Mesh& mesh : model.meshes) {
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      if (primitive.material >= 0 && primitive.attributes.contains("COLOR_0")) {
        coloured[static_cast<std::size_t>(primitive.material)] = true;
      }
    }
  }
  return coloured;
}

}  // namespace

std::vector<GltfMaterial> read_materials(GltfDocument& document, std::vector<Texture>& textures,
                                         LoadBudget& budget) {
  const std::vector<bool> coloured = with_vertex_colours(document.model);
  std::vector<GltfMaterial> materials;
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    materials.push_back(read_material(document, i));
  }
  textures = read_textures(document, materials, budget);
  for (std::size_t i = 0; i < materials.size(); ++i) {
    Material& material = materials[i].material;
    // The factor alone would weigh too little where the texture or the vertices have holes.
    if (material.blend && (material.base_texture || coloured[i])) {
      material.transmission = glm::vec3(1.0f);
    }
  }
  return materials;
}

Material default_material() {
  Material material = whitted({.base = glm::dvec3(0.8), .metallic = 0.0, .roughness = 1.0});
  material.name = "default";
  return material;
}

}  // namespace raycat
