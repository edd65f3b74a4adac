#pragma once

#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// Which primitives have a texture, by number; empty if none has.
std::vector<bool> textured_primitives(const Scene& scene);

}  // namespace raycat
