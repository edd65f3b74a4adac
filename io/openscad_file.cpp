#include "io/openscad_file.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/contained_path.hpp"
#include "io/excerpt.hpp"
#include "io/input_file.hpp"
#include "io/mesh_file.hpp"
#include "io/openscad_made.hpp"
#include "io/openscad_parameters.hpp"

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
  const std::string extension = lower_extension(file);
  if (extension != ".stl" && extension != ".off" && extension != ".obj") {
    parameters.fail(fmt::format("reads .stl, .off and .obj, not '{}'", excerpt(file.string())));
  }
  try {
    return joined(context, node, read_mesh_file(file));
  } catch (const LoadError& error) {
    parameters.fail(error.what());
  }
}

}  // namespace

std::optional<Primitive> file_primitive(Context& context, const Node& node) {
  if (node.name == "import") {
    return import(context, node);
  }
  Context::fail(node, "is not supported");
}

}  // namespace raycat::openscad
