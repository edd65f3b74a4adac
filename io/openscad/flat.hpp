#pragma once

#include "io/openscad/context.hpp"
#include "modelling/polygons.hpp"

namespace raycat::openscad {

/// What a square, circle, polygon or text node shows; nothing if it has no area. Throws
/// `NodeError` for a parameter of the wrong type, too many corners, or a font that is not there.
Polygons flat_primitive(Context& context, const Node& node);

}  // namespace raycat::openscad
