#pragma once

#include "io/files/load_budget.hpp"
#include "io/gltf/document.hpp"

namespace raycat {

/// Replaces buffer views that EXT_meshopt_compression or KHR_meshopt_compression has compressed by
/// plain ones, in buffers of their own. A view that cannot be decoded keeps the uncompressed data
/// that it falls back on, with a warning. Throws `LoadError` if it has none.
void decode_meshopt(GltfDocument& document, LoadBudget& budget);

}  // namespace raycat
