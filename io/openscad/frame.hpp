#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "io/openscad/context.hpp"

namespace raycat::openscad {

/// The map that a multmatrix node states, divided by its last number. Throws `NodeError`.
glm::dmat4 matrix_of(Context& context, const Node& node);

/// The colour that a color node sets, sRGB; nothing if it leaves the colour unset. Throws
/// `NodeError`.
std::optional<glm::vec3> colour_of(Context& context, const Node& node);

}  // namespace raycat::openscad
