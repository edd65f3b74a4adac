#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"
#include "io/scene/closed_scene.hpp"
#include "tests/io/gltf/files.hpp"
#include "tests/io/scene_text.hpp"
#include "tests/support/sanitized.hpp"

namespace raycat {
namespace {

// The fields of a line of CSV, where quotes hold commas.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    quoted = quoted != (c == '"');
    if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c != '"') {
      fields.back() += c;
    }
  }
  return fields;
}

TEST_CASE("real glTF assets have the triangles that the Khronos validator counts", "[io][gltf]") {
  const auto folder = corpus() / "gltf";
  std::ifstream manifest(folder / "manifest.csv");
  if (!manifest) {
    WARN("skipped: no corpus");
    return;
  }
  std::string line;
  std::getline(manifest, line);
  const std::vector<std::string> names = fields(line);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  std::size_t loaded = 0;
  while (std::getline(manifest, line)) {
    const std::vector<std::string> asset = fields(line);
    INFO(line);
    try {
      const SceneFile file = load_scene(folder / asset.at(column("file")));
      CHECK(file.triangles == std::stoull(asset.at(column("instanced_triangles"))));
      CHECK(file.scene.surfaces.faces() > 0);
      ++loaded;
    } catch (const LoadError& error) {
      // The validator's word for it: a buffer view past the end of its buffer.
      CHECK(asset.at(column("validator_error_codes")).find("BUFFER_VIEW_TOO_LONG") !=
            std::string::npos);
      CHECK(std::string(error.what()).find("overrun the") != std::string::npos);
    }
  }
  CHECK(loaded > 0);
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

// The program ends, and the test with it, when a file takes longer than any should.
class Alarm {
 public:
  explicit Alarm(unsigned seconds) { alarm(seconds); }
  ~Alarm() { alarm(0); }
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;
};

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST_CASE("bad glTF files load or are refused in one line, in little time and memory",
          "[io][gltf]") {
  const auto folder = corpus() / "gltf-bad";
  if (!std::filesystem::exists(folder)) {
    WARN("skipped: no corpus");
    return;
  }
  LoadOptions options;
  options.limits.memory = std::uint64_t{256} << 20;
  const long before = peak_kilobytes();
  for (const auto& file : gltf_files(folder)) {
    INFO(file);
    const Alarm alarm(sanitized ? 30 : 5);
    try {
      load_scene(file, options);
    } catch (const LoadError& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
  CHECK(peak_kilobytes() - before < (sanitized ? 4 : 1) * (256 << 10));
}

}  // namespace
}  // namespace raycat
