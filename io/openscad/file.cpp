#include "io/openscad/file.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/files/contained_path.hpp"
#include "io/files/excerpt.hpp"
#include "io/files/input_file.hpp"
#include "io/files/load_error.hpp"
#include "io/files/scene_kind.hpp"
#include "io/meshes/mesh_file.hpp"
#include "io/openscad/height_file.hpp"
#include "io/openscad/made.hpp"
#include "io/openscad/parameters.hpp"
#include "modelling/height_map.hpp"

namespace raycat::openscad {

namespace {

std::filesystem::path file_of(const Context& context, const Parameters& parameters) {
  try {
    return contained_path(context.file.parent_path(), parameters.text("file", ""), "file");
  } catch (const std::runtime_error& error) {
    parameters.fail(error.what());
  }
}

std::optional<Primitive> import(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"file", "layer", "convexity"},
                              {"origin", "scale", "filename", "center", "dpi", "id"});
  const std::filesystem::path file = file_of(context, parameters);
  const SceneKind kind = scene_kind(file);
  if (kind != SceneKind::stl && kind != SceneKind::off && kind != SceneKind::obj) {
    parameters.fail(fmt::format("reads .stl, .off and .obj, not '{}'", excerpt(file.string())));
  }
  try {
    MeshFile read = read_mesh_file(file, kind);
    if (!read.warning.empty()) {
      context.warn(node, fmt::format("'{}' {}", excerpt(file.filename().string()), read.warning));
    }
    return solid_with_faces(context, node, std::move(read.triangles));
  } catch (const LoadError& error) {
    parameters.fail(error.what());
  }
}

std::optional<Primitive> surface(Context& context, const Node& node) {
  const Parameters parameters(context, node, {"file", "center", "convexity"}, {"invert"});
  const std::filesystem::path file = file_of(context, parameters);
  const bool centred = parameters.flag("center", false);
  try {
    const HeightRows rows = read_heights(file, parameters.flag("invert", false));
    std::size_t widest = 0;
    for (const std::vector<double>& row : rows) {
      widest = std::max(widest, row.size());
    }
    context.require_triangles(node, 4 * std::uint64_t{widest} * rows.size());
    return solid(context, node, height_map(rows, centred));
  } catch (const std::runtime_error& error) {
    parameters.fail(fmt::format("file '{}': {}", excerpt(file.filename().string()), error.what()));
  }
}

}  // namespace

std::optional<Primitive> file_primitive(Context& context, const Node& node) {
  return node.name == "import" ? import(context, node) : surface(context, node);
}

}  // namespace raycat::openscad
