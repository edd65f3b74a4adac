#include "io/files/scene_kind.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "io/files/input_file.hpp"

namespace raycat {
namespace {

constexpr std::array<std::pair<std::string_view, SceneKind>, 8> kinds{{
    {".gltf", SceneKind::gltf},
    {".glb", SceneKind::gltf},
    {".csg", SceneKind::csg},
    {".scad", SceneKind::scad},
    {".obj", SceneKind::obj},
    {".ply", SceneKind::ply},
    {".stl", SceneKind::stl},
    {".off", SceneKind::off},
}};

// What is no regular file is not opened, which could take forever.
bool begins_as_glb(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return false;
  }
  std::array<char, 4> magic{};
  std::ifstream in(file, std::ios::binary);
  in.read(magic.data(), magic.size());
  return std::string_view(magic.data(), magic.size()) == "glTF";
}

}  // namespace

SceneKind scene_kind(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  const auto known =
      std::ranges::find(kinds, extension, [](const auto& kind) { return kind.first; });
  const SceneKind named = known == kinds.end() ? SceneKind::other : known->second;
  return named != SceneKind::gltf && begins_as_glb(file) ? SceneKind::gltf : named;
}

}  // namespace raycat
