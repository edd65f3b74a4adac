#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "io/scene/scene_file.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// Names that occur once: a second `ball` becomes `ball (2)`.
class UniqueNames {
 public:
  std::string add(const std::string& name);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, std::uint32_t> count_;
};

/// A scene file as it is put together. Ids are by name, so objects and primitives get names of
/// their own.
class SceneAssembly {
 public:
  explicit SceneAssembly(std::filesystem::path file) : file_(std::move(file)) {}

  void add_object(const std::string& name);

  /// Throws `LoadError` if the scene would have more than 2^27 faces: instances are cheap in a
  /// file, but each has faces of its own.
  SurfaceId add_primitive(const std::string& name, std::uint32_t faces);

  SceneFile out;

 private:
  std::filesystem::path file_;
  UniqueNames objects_;
  UniqueNames primitives_;
};

}  // namespace raycat
