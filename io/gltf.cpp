#include "io/gltf.hpp"

#include "io/gltf_assets.hpp"
#include "io/gltf_scene.hpp"

namespace raycat {

SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options) {
  GltfAssets assets(options);
  return read_gltf_scene(file, std::nullopt, assets);
}

}  // namespace raycat
