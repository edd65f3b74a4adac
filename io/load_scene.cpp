#include "io/load_scene.hpp"

#include <glm/gtx/component_wise.hpp>

#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/files/scene_kind.hpp"
#include "io/gltf/reader.hpp"
#include "io/meshes/mesh_scene.hpp"
#include "io/openscad/reader.hpp"

namespace raycat {
namespace {

SceneFile read(const std::filesystem::path& file, SceneKind kind, const LoadOptions& options);

SceneFile read_by_kind(const std::filesystem::path& file, SceneKind kind,
                       const LoadOptions& options) {
  switch (kind) {
    case SceneKind::gltf:
      return read_gltf(file, options, read);  // which reads what its nodes place
    case SceneKind::csg:
    case SceneKind::scad:
      return read_openscad(file, kind, options);
    case SceneKind::obj:
    case SceneKind::ply:
    case SceneKind::stl:
    case SceneKind::off:
      return read_mesh_scene(file, kind, options);
    case SceneKind::other:
      break;
  }
  throw LoadError(file, "",
                  "unknown kind of scene file: the name must end in .gltf, .glb, .csg, .scad, "
                  ".obj, .ply, .stl or .off");
}

SceneFile read(const std::filesystem::path& file, SceneKind kind, const LoadOptions& options) {
  SceneFile scene = read_by_kind(file, kind, options);
  const Bounds box = bounds(scene.scene);
  if (!box.empty() && !(glm::compMax(glm::max(glm::abs(box.min), glm::abs(box.max))) < 1e18)) {
    throw LoadError(file, "", "a scene reaches at most 1e18 units from the origin");
  }
  return scene;
}

}  // namespace

SceneFile load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  require_regular_file(file);
  SceneFile scene = read(file, scene_kind(file), options);
  if (scene.scene.surfaces.faces() == 0 && scene.warnings.empty()) {  // which say why
    scene.warnings.emplace_back("the scene holds nothing to see");
  }
  return scene;
}

}  // namespace raycat
