#pragma once

#include <cstdint>

#include "geometry/mesh.hpp"

namespace raycat::bench {

/// A closed mesh of 2 `rings` `columns` triangles: a ball of radius about 1 round the origin,
/// with bumps, so that it hides parts of itself. Faces are patches of about 16 x 16 quads.
TriangleMesh bumpy_sphere(std::uint32_t columns, std::uint32_t rings);

}  // namespace raycat::bench
