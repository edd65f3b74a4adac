#include "io/gltf/material.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/files/excerpt.hpp"

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
    pbr.attenuation_colour = limit(
        "attenuationColor", fields->vector("attenuationColor").value_or(glm::dvec3(1.0)), 0.0, 1.0);
    pbr.attenuation_distance = limit(
        "attenuationDistance", fields->number("attenuationDistance").value_or(0.0), 0.0, 1e300);
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

Material read_constants(JsonFields fields, const std::string& name) {
  Material material;
  material.name = name;
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
  for (const auto& [key, colour] :
       {std::pair("emission", material.emission), std::pair("ambient", material.ambient),
        std::pair("diffuse", material.diffuse), std::pair("specular", material.specular),
        std::pair("reflection", material.reflection),
        std::pair("transmission", material.transmission)}) {
    for (int c = 0; c < 3; ++c) {
      in_range(fields, key, static_cast<double>(colour[c]), 0.0, any);
    }
  }
  return material;
}

// The constants themselves, where the material's extras say them.
std::optional<Material> whitted_extras(const GltfDocument& document, const nlohmann::json& json,
                                       const std::string& place, const std::string& name) {
  const auto extras = json.find("extras");
  if (extras == json.end() || !extras->is_object()) {
    return std::nullopt;
  }
  JsonFields fields(document.file, place, "extras", *extras);
  auto constants = fields.object("whitted");
  if (!constants) {
    return std::nullopt;
  }
  Material material = read_constants(*std::move(constants), name);
  fields.refuse_others();
  return material;
}

void read_alpha(const tinygltf::Material& from, const JsonFields& fields, const Limits& limit,
                const Pbr& pbr, Material& to) {
  if (from.alphaMode == "BLEND") {
    to.blend = true;
    to.alpha = static_cast<float>(pbr.alpha);
    to.thin = true;
    to.absorption = glm::vec3(0.0f);
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

// The textures of one material.
class Maps {
 public:
  Maps(const GltfDocument& document, std::size_t number, std::string place, GltfTextures& textures,
       CoordinateSets& sets)
      : document_(document),
        json_(document.json["materials"][number]),
        place_(std::move(place)),
        textures_(textures),
        sets_(sets) {}

  std::optional<TextureMap> base() {
    auto factors = own("pbrMetallicRoughness");
    auto glossy = extension("KHR_materials_pbrSpecularGlossiness");
    return glossy    ? map(*glossy, "diffuseTexture")
           : factors ? map(*factors, "baseColorTexture")
                     : std::nullopt;
  }

  VaryingPbr others(const Pbr& factors) {
    VaryingPbr to{.factors = factors};
    if (auto occlusion = own("occlusionTexture")) {
      to.occlusion = textures_.map(*occlusion, sets_);
      to.occlusion_strength = std::clamp(occlusion->number("strength").value_or(1.0), 0.0, 1.0);
    }
    if (auto emission = own("emissiveTexture")) {
      to.emission = textures_.map(*emission, sets_);
    }
    if (auto fields = extension("KHR_materials_transmission")) {
      to.transmission = map(*fields, "transmissionTexture");
    }
    if (auto fields = extension("KHR_materials_pbrSpecularGlossiness")) {
      to.specular_colour = map(*fields, "specularGlossinessTexture");
      to.glossiness = to.specular_colour;
      return to;
    }
    if (auto fields = own("pbrMetallicRoughness")) {
      to.metallic_roughness = map(*fields, "metallicRoughnessTexture");
    }
    if (auto fields = extension("KHR_materials_specular")) {
      to.specular = map(*fields, "specularTexture");
      to.specular_colour = map(*fields, "specularColorTexture");
    }
    return to;
  }

 private:
  std::optional<JsonFields> own(const char* key) const {
    return JsonFields(document_.file, place_, "", json_).object(key);
  }

  std::optional<JsonFields> extension(const char* name) const {
    return document_.extension(json_, name, place_);
  }

  std::optional<TextureMap> map(JsonFields& fields, const char* key) {
    auto info = fields.object(key);
    return info ? textures_.map(*info, sets_) : std::nullopt;
  }

  const GltfDocument& document_;
  const nlohmann::json& json_;
  std::string place_;
  GltfTextures& textures_;
  CoordinateSets& sets_;
};

// Does any constant vary in more than the base colour that all of it is multiplied with?
bool varies(const VaryingPbr& pbr, bool base_varies) {
  const bool base_is_reflected = pbr.factors.metallic > 0.0 || pbr.factors.transmission > 0.0;
  return pbr.metallic_roughness || pbr.occlusion || pbr.emission || pbr.transmission ||
         pbr.specular || pbr.specular_colour || (base_varies && base_is_reflected);
}

GltfMaterial read_material(GltfDocument& document, std::size_t number, bool coloured,
                           GltfTextures& textures) {
  const tinygltf::Material& from = document.model.materials[number];
  const auto& json = document.json["materials"][number];
  const std::string place = from.name.empty()
                                ? fmt::format("materials[{}]", number)
                                : fmt::format("materials[{}] '{}'", number, excerpt(from.name));
  const Limits limit(document.warnings, place);
  Pbr pbr = read_pbr(from, limit);
  read_extensions(document, json, place, limit, pbr);
  if (auto fields = document.extension(json, "KHR_materials_pbrSpecularGlossiness", place)) {
    read_glossiness(*fields, limit, pbr);
  }
  GltfMaterial to{.material = whitted(pbr)};
  to.material.name = from.name;
  Maps maps(document, number, place, textures, to.coordinates);
  to.material.base_texture = maps.base();
  const auto outright = whitted_extras(document, json, place, from.name);
  if (outright) {
    const std::optional<TextureMap> base = to.material.base_texture;
    to.material = *outright;
    to.material.base_texture = base;
    return to;
  }
  const bool base_varies = coloured || to.material.base_texture.has_value();
  if (!pbr.unlit) {
    VaryingPbr varying = maps.others(pbr);
    if (varying.metallic_roughness) {
      // A metal factor of 1, the default, says no more than that the texture tells where metal is.
      Pbr glass = pbr;
      glass.metallic = 0.0;
      to.material.transmission = whitted(glass).transmission;
    }
    if (varies(varying, base_varies)) {
      to.material.varying = std::make_shared<const VaryingPbr>(std::move(varying));
    }
  }
  read_alpha(from, JsonFields(document.file, place, "", json), limit, pbr, to.material);
  // The factor alone would weigh too little where the texture or the vertices have holes.
  if (to.material.blend && base_varies) {
    to.material.transmission = glm::vec3(1.0f);
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

std::vector<GltfMaterial> read_materials(GltfDocument& document, GltfTextures& textures,
                                         BackFaces back_faces) {
  const std::vector<bool> coloured = with_vertex_colours(document.model);
  std::vector<GltfMaterial> materials;
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    GltfMaterial& read = materials.emplace_back(read_material(document, i, coloured[i], textures));
    // What lets light through has an inside, which shows its back faces.
    read.material.single_sided = back_faces == BackFaces::hide &&
                                 !document.model.materials[i].doubleSided && !read.material.blend &&
                                 read.material.transmission == glm::vec3(0.0f);
  }
  return materials;
}

Material default_material(BackFaces back_faces) {
  Material material = whitted({.base = glm::dvec3(0.8), .metallic = 0.0, .roughness = 1.0});
  material.name = "default";
  material.single_sided = back_faces == BackFaces::hide;
  return material;
}

}  // namespace raycat
