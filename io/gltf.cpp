#include "io/gltf.hpp"

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "io/gltf_assets.hpp"
#include "io/gltf_scene.hpp"
#include "io/input_file.hpp"

namespace raycat {

bool is_gltf(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".gltf" || extension == ".glb") {
    return true;
  }
  std::array<char, 4> magic{};
  std::ifstream in(file, std::ios::binary);
  in.read(magic.data(), magic.size());
  return std::string_view(magic.data(), magic.size()) == "glTF";
}

SceneFile read_gltf(const std::filesystem::path& file, const LoadOptions& options) {
  GltfAssets assets(options);
  SceneFile scene = read_gltf_scene(file, std::nullopt, assets);
  scene.seconds = assets.budget().spent();
  return scene;
}

}  // namespace raycat
