#include "fuzz/loaded_file.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "io/files/load_error.hpp"
#include "io/load_scene.hpp"
#include "render/render.hpp"
#include "support/temporary_folder.hpp"

namespace raycat {
namespace {

// Beyond, what takes the time is what was asked for, and tells nothing of the reader.
constexpr std::size_t most_faces = 2000;
constexpr std::uint64_t most_triangles = 20'000;

void trace(const SceneFile& file) {
  const Scene& scene = file.scene;
  const Bounds box = bounds(scene);
  if (box.empty() || scene.surfaces.faces() > most_faces || file.triangles > most_triangles) {
    return;
  }
  const Camera camera = scene.cameras.empty()
                            ? frame(box, three_quarter(file.up), file.up, 1.0, false)
                            : scene.cameras.front();
  const Accel accel(scene);
  render(accel, camera, {.width = 4, .height = 4, .levels = 3});
}

}  // namespace

void load_bytes(std::span<const std::uint8_t> bytes, const std::filesystem::path& name) {
  static const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / name;
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  try {
    trace(load_scene(file));
  } catch (const LoadError& error) {
    const std::string_view line = error.what();
    if (line.find('\n') != std::string_view::npos) {
      std::fprintf(stderr, "not one line: %s\n", error.what());
      std::abort();
    }
  }
}

}  // namespace raycat
