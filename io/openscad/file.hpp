#pragma once

#include <optional>

#include "io/openscad/context.hpp"
#include "io/openscad/primitive.hpp"

namespace raycat::openscad {

/// What an import or surface node reads from a file beside the scene's or below. Throws `NodeError`
/// for a file that is missing, of a kind that is not read, or not closed.
std::optional<Primitive> file_primitive(Context& context, const Node& node);

}  // namespace raycat::openscad
