#pragma once

#include "io/files/load_budget.hpp"
#include "io/gltf/document.hpp"

namespace raycat {

/// Gives primitives that KHR_draco_mesh_compression has compressed plain accessors, with data in
/// buffers of their own. A primitive that cannot be decoded keeps the uncompressed data that it
/// falls back on, with a warning. Throws `LoadError` if it has none.
void decode_draco(GltfDocument& document, LoadBudget& budget);

}  // namespace raycat
