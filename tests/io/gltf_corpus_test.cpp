#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "io/closed_scene.hpp"
#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

std::vector<std::filesystem::path> gltf_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".gltf" || extension == ".glb") {
      files.push_back(entry.path());
    }
  }
  return files;
}

TEST_CASE("real glTF assets load, or need an extension that is not supported", "[io][gltf]") {
  const auto folder = corpus() / "gltf";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  for (const auto& file : gltf_files(folder)) {
    INFO(file);
    try {
      const auto loaded = load_scene(file);
      CHECK(loaded.scene.surfaces.faces() > 0);
    } catch (const LoadError& error) {
      const std::string message = error.what();
      const bool unsupported = message.ends_with("is required but not supported");
      // Its last buffer is really too short.
      const bool teapots = message.find("teapots_galore") != std::string::npos;
      CHECK((unsupported || teapots));
    }
  }
}

TEST_CASE("known assets have the triangles and faces that they should", "[io][gltf]") {
  const auto folder = corpus() / "gltf";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  const auto box = load_scene(folder / "box_glb/Box.glb");
  CHECK(box.triangles == 12);
  CHECK(box.scene.surfaces.faces() == 6);
  CHECK(is_closed(box.scene));
  CHECK(load_scene(folder / "box_textured_ext/BoxTextured.gltf").scene.textures.size() == 1);
  CHECK(load_scene(folder / "milktruck/CesiumMilkTruck.glb").triangles == 3624);
  CHECK(load_scene(folder / "engine/2CylinderEngine.glb").triangles == 121496);
  CHECK(load_scene(folder / "all_modes/MeshPrimitiveModes.gltf").triangles == 16);
  CHECK(load_scene(folder / "cube_strip/cubeStrip.glb").triangles == 18);
  CHECK(load_scene(folder / "cube_quantized/cubeQuantized.glb").scene.surfaces.faces() == 6);
}

TEST_CASE("bad glTF files load or are refused in one line", "[io][gltf]") {
  const auto folder = corpus() / "gltf-bad";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  for (const auto& file : gltf_files(folder)) {
    INFO(file);
    try {
      load_scene(file);
    } catch (const LoadError& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
}

}  // namespace
}  // namespace raycat
