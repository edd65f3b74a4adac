#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/gltf/document.hpp"
#include "io/images/decode.hpp"
#include "tracer/material.hpp"
#include "tracer/texture.hpp"

namespace raycat {

/// Which TEXCOORD_n each of a mesh's sets of texture coordinates is.
using CoordinateSets = std::vector<std::size_t>;

/// What a glTF `textureInfo` says.
struct GltfTextureInfo {
  std::size_t texture = 0;
  TexturePlace place;
};

/// The textures of a document, each decoded when it is first asked for. An image that is missing
/// or broken is a warning, and its texture none.
class GltfTextures {
 public:
  /// Keeps references to all three. Textures of materials are appended to `out`.
  GltfTextures(GltfDocument& document, std::vector<Texture>& out, LoadBudget& budget)
      : document_(document), out_(out), budget_(budget) {}

  /// Reads a `textureInfo` with its KHR_texture_transform, its coordinates counted among `sets`,
  /// where they are put if they are not there yet. Throws `LoadError` if it is malformed.
  GltfTextureInfo info(JsonFields& fields, CoordinateSets& sets) const;

  /// As `info`, and the texture with it.
  std::optional<TextureMap> map(JsonFields& fields, CoordinateSets& sets);

  /// The texels of a texture as they are, for what is not seen.
  std::optional<std::pair<TexelGrid, std::vector<std::uint8_t>>> texels(std::size_t texture);

 private:
  std::optional<DecodedImage> decode(std::size_t texture);
  std::vector<std::size_t> images(std::size_t texture) const;

  GltfDocument& document_;
  std::vector<Texture>& out_;
  LoadBudget& budget_;
  std::map<std::pair<std::vector<std::size_t>, int>, std::optional<TextureId>>
      known_;  // images, sampler
};

}  // namespace raycat
