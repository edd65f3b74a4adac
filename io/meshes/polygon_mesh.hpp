#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace raycat {

/// What a mesh file says: points, and polygons as indices of points, which need not exist.
struct PolygonMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::string warning;  ///< of what is odd in the file; empty if nothing is
};

// Each takes the bytes of a file, keeps what makes the surface and passes over the rest. They throw
// `std::invalid_argument` that says where the file is wrong. Nothing is reserved that the bytes do
// not bear out.

/// Wavefront OBJ: `v`, and `f` with indices from either end.
PolygonMesh read_obj(std::string_view bytes);

/// Geomview's OFF with its variants for colours, normals and texture coordinates, text or binary.
PolygonMesh read_off(std::string_view bytes);

/// PLY, text or binary of either byte order, with faces or triangle strips.
PolygonMesh read_ply(std::string_view bytes);

/// STL, text or binary.
PolygonMesh read_stl(std::string_view bytes);

}  // namespace raycat
