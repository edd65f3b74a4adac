#include "io/gltf/textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat {
namespace {

constexpr std::size_t max_coordinates = 1000;

// Where an extension names an image of another format than glTF's own.
constexpr auto image_extensions =
    std::to_array<const char*>({"EXT_texture_webp", "KHR_texture_basisu", "MSFT_texture_dds"});

Wrap wrap(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirror;
    default:
      return Wrap::repeat;
  }
}

tinygltf::Sampler sampler_of(const tinygltf::Model& model, const tinygltf::Texture& texture) {
  return texture.sampler < 0 ? tinygltf::Sampler{}
                             : model.samplers[static_cast<std::size_t>(texture.sampler)];
}

std::size_t set_of(std::size_t coordinates, CoordinateSets& sets) {
  const auto found = std::ranges::find(sets, coordinates);
  const auto set = static_cast<std::size_t>(found - sets.begin());
  if (found == sets.end()) {
    sets.push_back(coordinates);
  }
  return set;
}

}  // namespace

GltfTextureInfo GltfTextures::info(JsonFields& fields, CoordinateSets& sets) const {
  GltfTextureInfo info;
  const auto texture = fields.index("index", "textures", document_.model.textures.size());
  if (!texture) {
    fields.fail("needs an index");
  }
  info.texture = *texture;
  std::size_t coordinates =
      fields.index("texCoord", "TEXCOORD", max_coordinates).value_or(std::size_t{0});
  auto extensions = fields.object("extensions");
  auto transform = extensions ? extensions->object("KHR_texture_transform") : std::nullopt;
  if (transform) {
    const auto offset = transform->vector2("offset").value_or(glm::dvec2(0.0));
    const auto scale = transform->vector2("scale").value_or(glm::dvec2(1.0));
    const double angle = transform->number("rotation").value_or(0.0);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    info.place.transform = {c * scale.x, -s * scale.x, s * scale.y,
                            c * scale.y, offset.x,     offset.y};
    coordinates = transform->index("texCoord", "TEXCOORD", max_coordinates).value_or(coordinates);
  }
  info.place.coordinates = set_of(coordinates, sets);
  return info;
}

std::optional<TextureMap> GltfTextures::map(JsonFields& fields, CoordinateSets& sets) {
  const GltfTextureInfo info = this->info(fields, sets);
  const tinygltf::Texture& texture = document_.model.textures[info.texture];
  const auto [found, added] = known_.try_emplace({images(info.texture), texture.sampler});
  if (added) {
    if (auto image = decode(info.texture)) {
      const tinygltf::Sampler sampler = sampler_of(document_.model, texture);
      out_.emplace_back(image->width, image->height, std::move(image->rgba), wrap(sampler.wrapS),
                        wrap(sampler.wrapT), sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST);
      found->second = static_cast<TextureId>(out_.size() - 1);
    }
  }
  if (!found->second) {
    return std::nullopt;
  }
  return TextureMap{.texture = *found->second, .place = info.place};
}

std::optional<std::pair<TexelGrid, std::vector<std::uint8_t>>> GltfTextures::texels(
    std::size_t texture) {
  auto image = decode(texture);
  if (!image) {
    return std::nullopt;
  }
  const tinygltf::Sampler sampler = sampler_of(document_.model, document_.model.textures[texture]);
  return std::pair(TexelGrid{.width = image->width,
                             .height = image->height,
                             .wrap_s = wrap(sampler.wrapS),
                             .wrap_t = wrap(sampler.wrapT)},
                   std::move(image->rgba));
}

// glTF's own image first, then those that extensions put in its place.
std::vector<std::size_t> GltfTextures::images(std::size_t texture) const {
  std::vector<std::size_t> images;
  if (const int source = document_.model.textures[texture].source; source >= 0) {
    images.push_back(static_cast<std::size_t>(source));
  }
  const std::size_t count = document_.json.value("images", nlohmann::json::array()).size();
  for (const char* name : image_extensions) {
    if (auto fields = document_.extension(document_.json["textures"][texture], name,
                                          fmt::format("textures[{}]", texture))) {
      if (const auto source = fields->index("source", "images", count)) {
        images.push_back(*source);
      }
    }
  }
  return images;
}

std::optional<DecodedImage> GltfTextures::decode(std::size_t texture) {
  const SpentTime decoding(budget_.spent().images);
  const std::vector<std::size_t> all = images(texture);
  if (all.empty()) {
    document_.warnings.emplace_back("a texture has no image and is left out");
  }
  std::vector<std::string> reasons;
  for (const std::size_t image : all) {
    const std::string place = fmt::format("images[{}]", image);
    try {
      const Bytes bytes = document_.image_bytes(image, budget_);
      return decode_image(bytes, budget_.limits().pixels, [&](std::uint64_t size) {
        budget_.take_memory(document_.file, place, size);
      });
    } catch (const LoadError&) {
      throw;
    } catch (const std::runtime_error& error) {
      reasons.push_back(fmt::format("{}: {}; it is left out", place, error.what()));
    }
  }
  document_.warnings.insert(document_.warnings.end(), reasons.begin(), reasons.end());
  return std::nullopt;
}

}  // namespace raycat
