#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"

namespace raycat {

/// How triangles join into faces.
struct FaceRule {
  double crease = 0.5235987755982988;        ///< radians; 30 degrees (docs/design.md, Ids)
  double same_normal = 0.08726646259971647;  ///< radians; authored normals within 5 degrees
};

/// The faces of triangles.
struct MeshFaces {
  /// Of each triangle, numbered from 0 in the order of each face's first triangle.
  std::vector<std::uint32_t> faces;
  std::vector<std::uint32_t> twins;  ///< as `coincident_twins` has them
};

/// Joins triangles into faces. Two that share an edge, once equal positions are welded, are of one
/// face when the authored normals agree at both ends within `rule.same_normal`, or the angle of the
/// planes is under `rule.crease` (see `Crease`). An edge of three or more joins those pairs that
/// run along it in opposite directions; of two that run along it the same way one is turned over;
/// an edge of more than 64 joins none. Triangles on the same three points are of one face and count
/// once, whichever way round. Edges that only one triangle has are cut at each other's ends where
/// these lie on them (`edge_parts`), and the parts compared. Degenerate triangles belong to the
/// face of a neighbour, and join nothing. `normals` holds one a position, or nothing. Indices must
/// be in range.
/// The faces are the same whatever `threads`.
MeshFaces group_faces(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
                      std::span<const glm::vec3> normals, const FaceRule& rule = {},
                      int threads = 1);

/// The faces of triangles whose borders are told: two triangles that share an edge, once equal
/// positions are welded, are of one face unless the edge is among `borders`, pairs of positions in
/// either order, or they lie on the same three points.
MeshFaces group_faces_between(std::span<const glm::dvec3> positions,
                              std::span<const glm::uvec3> triangles,
                              std::span<const glm::uvec2> borders, int threads = 1);

/// A mesh of polygons as triangles, with face k the polygon k. A face of `faces` lists the
/// corners of one planar polygon counter-clockwise from outside, convex or not. Throws
/// `std::invalid_argument`, naming the face, for a corner out of range or fewer than three.
/// `face_of`, if given, maps each polygon to its face, so that facets of one curved surface can
/// be one face.
TriangleMesh triangulate(std::vector<glm::dvec3> points,
                         std::span<const std::vector<std::uint32_t>> faces,
                         std::span<const std::uint32_t> face_of = {});

}  // namespace raycat
