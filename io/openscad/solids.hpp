#pragma once

#include <cstdint>

#include "io/openscad/context.hpp"
#include "io/openscad/item.hpp"

namespace raycat::openscad {

/// What the nodes of a file come to, and which of them is the scene: the file, or the one marked
/// with `!`.
struct Solids {
  Items items;
  std::uint32_t root = 0;
};

/// Works out what every node is, by OpenSCAD's rules: `*` and `%` nodes are left out, a difference
/// whose first operand is empty is empty, an intersection with an empty operand is empty, and the
/// first operand says whether an operation is in two or three dimensions. Refers to `parsed`.
/// Throws `LoadError` for nodes that are unknown, cannot be made, or have bad parameters.
Solids evaluate(Context& context, const File& parsed);

}  // namespace raycat::openscad
