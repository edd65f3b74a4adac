#include "io/scene_file.hpp"

#include <algorithm>

#include <glm/gtx/component_wise.hpp>

#include "io/gltf.hpp"
#include "io/input_file.hpp"
#include "io/mesh_scene.hpp"
#include "io/openscad.hpp"

namespace raycat {

namespace {

// The message is one line whatever the file is called or holds.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
  return text;
}

std::string message(const std::filesystem::path& file, const std::string& place,
                    const std::string& what) {
  return one_line(file.string() + ": " + (place.empty() ? "" : place + ": ") + what);
}

}  // namespace

LoadError::LoadError(const std::filesystem::path& file, const std::string& place,
                     const std::string& what)
    : std::runtime_error(message(file, place, what)) {}

namespace {

SceneFile read(const std::filesystem::path& file, const LoadOptions& options) {
  require_regular_file(file);
  if (is_gltf(file)) {
    return read_gltf(file, options);
  }
  const std::string extension = lower_extension(file);
  if (extension == ".csg" || extension == ".scad") {
    return read_openscad(file, options);
  }
  if (extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off") {
    return read_mesh_scene(file, options);
  }
  throw LoadError(file, "",
                  "unknown kind of scene file: the name must end in .gltf, .glb, .csg, .scad, "
                  ".obj, .ply, .stl or .off");
}

}  // namespace

SceneFile load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  SceneFile scene = read(file, options);
  const Bounds box = bounds(scene.scene);
  if (!box.empty() && !(glm::compMax(glm::max(glm::abs(box.min), glm::abs(box.max))) < 1e18)) {
    throw LoadError(file, "", "a scene reaches at most 1e18 units from the origin");
  }
  return scene;
}

}  // namespace raycat
