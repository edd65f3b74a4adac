#pragma once

#include <string>

#include "raytree/surface_table.hpp"

namespace raycat {

/// `object/primitive/face` for files whose names end at white space: what a name may not hold is
/// an underscore. Names that are apart by that alone become one.
std::string surface_label(const SurfaceTable& surfaces, SurfaceId face);

/// A name as one word.
std::string one_word(std::string name);

}  // namespace raycat
