#include "io/scene/assembly.hpp"

#include <fmt/format.h>

#include "io/files/load_error.hpp"

namespace raycat {
namespace {

constexpr std::size_t max_faces = std::size_t{1} << 27;

}  // namespace

std::string UniqueNames::add(const std::string& name) {
  std::string unique = name;
  // The count is where the search for a free number starts, so that many equal names are cheap.
  std::uint32_t& count = count_.try_emplace(name, 1).first->second;
  while (!taken_.insert(unique).second) {
    unique = fmt::format("{} ({})", name, ++count);
  }
  return unique;
}

void SceneAssembly::add_object(const std::string& name) {
  out.scene.surfaces.add_object(objects_.add(name));
}

SurfaceId SceneAssembly::add_primitive(const std::string& name, std::uint32_t faces) {
  if (faces > max_faces - out.scene.surfaces.faces()) {
    throw LoadError(file_, "scene", fmt::format("scenes have at most {} faces", max_faces));
  }
  return out.scene.surfaces.add_primitive(primitives_.add(name), faces);
}

}  // namespace raycat
