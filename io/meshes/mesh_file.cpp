#include "io/meshes/mesh_file.hpp"

#include <cmath>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "geometry/joined_mesh.hpp"
#include "geometry/mesh_faces.hpp"
#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/meshes/polygon_mesh.hpp"

namespace raycat {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 32;

PolygonMesh read(std::string_view bytes, SceneKind kind) {
  switch (kind) {
    case SceneKind::obj:
      return read_obj(bytes);
    case SceneKind::off:
      return read_off(bytes);
    case SceneKind::ply:
      return read_ply(bytes);
    default:
      return read_stl(bytes);
  }
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& file, SceneKind kind) {
  const std::string bytes = read_input_file(file, most_bytes);
  try {
    PolygonMesh read_in = read(bytes, kind);
    for (std::size_t i = 0; i < read_in.points.size(); ++i) {
      const glm::vec3 point(read_in.points[i]);
      if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
        throw LoadError(file, fmt::format("vertex {}", i), "is not finite");
      }
    }
    MeshFile out{.triangles = triangulate(std::move(read_in.points), read_in.polygons),
                 .warning = std::move(read_in.warning)};
    if (kind == SceneKind::stl) {  // whose triangles have corners of their own
      weld_corners(out.triangles);
    }
    if (out.triangles.triangles.empty()) {
      throw LoadError(file, "", "holds no triangle");
    }
    out.triangles.faces.clear();
    out.triangles.face_count = 0;
    return out;
  } catch (const LoadError&) {
    throw;
  } catch (const std::exception& error) {
    throw LoadError(file, "", error.what());
  }
}

}  // namespace raycat
