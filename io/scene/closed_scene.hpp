#pragma once

#include "tracer/scene.hpp"

namespace raycat {

/// Does every object enclose a volume? Solids do. The meshes of an object do, if each edge between
/// their corners, which are told by position, runs as often one way as the other. Nothing is not
/// closed.
bool is_closed(const Scene& scene);

}  // namespace raycat
