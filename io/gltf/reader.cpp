#include "io/gltf/reader.hpp"

#include <optional>

#include "io/gltf/scene.hpp"

namespace raycat {

SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options,
                    const OtherReader& read_other) {
  GltfAssets assets(options, read_other);
  SceneFile scene = read_gltf_scene(file, std::nullopt, assets);
  scene.seconds = assets.budget().spent();
  return scene;
}

}  // namespace raycat
