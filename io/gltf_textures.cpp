#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "io/gltf_material.hpp"
#include "io/image_decode.hpp"
#include "io/scene_file.hpp"

namespace raycat {
namespace {

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

}  // namespace

std::vector<Texture> read_textures(GltfDocument& document, std::vector<GltfMaterial>& materials,
                                   LoadBudget& budget) {
  std::vector<Texture> textures;
  std::map<std::pair<int, int>, std::optional<TextureId>> known;  // by image and sampler

  const auto read = [&](int source, int sampler) -> std::optional<TextureId> {
    if (source < 0) {
      document.warnings.emplace_back("a texture has no image and is left out");
      return std::nullopt;
    }
    const auto image = static_cast<std::size_t>(source);
    try {
      const Bytes bytes = document.image_bytes(image, budget);
      DecodedImage decoded = decode_image(bytes, budget.limits().pixels, [&](std::uint64_t size) {
        budget.take_memory(document.file, fmt::format("images[{}]", image), size);
      });
      const tinygltf::Sampler of = sampler < 0
                                       ? tinygltf::Sampler{}
                                       : document.model.samplers[static_cast<std::size_t>(sampler)];
      textures.emplace_back(decoded.width, decoded.height, std::move(decoded.rgba), wrap(of.wrapS),
                            wrap(of.wrapT), of.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST);
      return static_cast<TextureId>(textures.size() - 1);
    } catch (const LoadError&) {
      throw;
    } catch (const std::runtime_error& error) {
      document.warnings.push_back(
          fmt::format("images[{}]: {}; its materials are untextured", image, error.what()));
      return std::nullopt;
    }
  };

  for (GltfMaterial& material : materials) {
    if (!material.texture) {
      continue;
    }
    const auto& texture = document.model.textures[*material.texture];
    const auto [found, added] = known.try_emplace({texture.source, texture.sampler});
    if (added) {
      found->second = read(texture.source, texture.sampler);
    }
    material.material.base_texture = found->second;
  }
  return textures;
}

}  // namespace raycat
