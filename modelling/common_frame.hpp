#pragma once

#include <glm/mat3x3.hpp>

#include "csg/tree.hpp"

namespace raycat {

/// Axes along which most leaves stand: unit vectors, right-handed, not always at right angles. In
/// their frame a model that was turned as a whole has faces across axes, whose places are plain
/// numbers. The identity where the leaves stand along the axes of the world.
glm::dmat3 common_frame(const CsgTree& tree);

}  // namespace raycat
