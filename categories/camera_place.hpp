#pragma once

#include "categories/path_syntax.hpp"

namespace raycat::paths {

/// Throws the `PathError` of the leftmost event that could be where it may not: every word begins
/// with C, the camera, and has no other C.
void require_camera_first(const PathNode& expression);

}  // namespace raycat::paths
