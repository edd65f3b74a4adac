#include "io/scene_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

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

bool is_binary_gltf(const std::filesystem::path& file) {
  std::array<char, 4> magic{};
  std::ifstream in(file, std::ios::binary);
  in.read(magic.data(), magic.size());
  return std::string_view(magic.data(), magic.size()) == "glTF";
}

}  // namespace

LoadError::LoadError(const std::filesystem::path& file, const std::string& place,
                     const std::string& what)
    : std::runtime_error(message(file, place, what)) {}

SceneFile load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  require_regular_file(file);
  const std::string extension = lower_extension(file);
  if (extension == ".gltf" || extension == ".glb" || is_binary_gltf(file)) {
    return read_gltf(file, options);
  }
  if (extension == ".csg") {
    return read_openscad(file, options);
  }
  if (extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off") {
    return read_mesh_scene(file, options);
  }
  throw LoadError(file, "",
                  "unknown kind of scene file: the name must end in .gltf, .glb, .csg, .obj, "
                  ".ply, .stl or .off");
}

}  // namespace raycat
