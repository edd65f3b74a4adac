#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/bounds.hpp"
#include "geometry/crossing.hpp"
#include "geometry/ray.hpp"

namespace raycat {

class TriangleIndex;

/// Indexed triangles with their faces. Counter-clockwise from outside.
struct TriangleMesh {
  std::vector<glm::dvec3> positions;
  std::vector<glm::uvec3> triangles;  ///< indices into `positions`
  std::vector<std::uint32_t> faces;   ///< face of each triangle; as long as `triangles`
  std::uint32_t face_count = 0;       ///< more than every entry of `faces`
};

Bounds bounds(const TriangleMesh& mesh);

/// That the mesh encloses, if it is closed; negative if it is inside out. Summed about the middle
/// of the mesh, so that a far one loses nothing.
double signed_volume(const TriangleMesh& mesh);

/// A mesh that encloses a volume: every edge is shared by as many triangles that run along it one
/// way as the other, if need be cut at vertices exactly on it. Overlapping shells are united, and
/// one turned inside out is a cavity (the solid is where the winding number is positive).
class ClosedMesh {
 public:
  /// Equal positions are taken as one vertex. Throws `std::invalid_argument` if the mesh has no
  /// volume, an index is out of range, a coordinate is not finite, or an edge is open or
  /// inconsistently oriented; then the message gives the two end points of the first such edge
  /// and the number of them.
  explicit ClosedMesh(TriangleMesh mesh);
  ~ClosedMesh();
  ClosedMesh(const ClosedMesh&) = delete;
  ClosedMesh& operator=(const ClosedMesh&) = delete;

  /// Appends all crossings of the whole line, ascending, entering and leaving in turn. Each
  /// passage through the surface counts once, also through edges and vertices (a symbolic
  /// perturbation of the line decides), so their number is even. Never inside at -infinity.
  void cross(const Ray& ray, Crossings& out) const;

  const TriangleMesh& mesh() const noexcept { return mesh_; }
  const Bounds& bounds() const noexcept;

 private:
  TriangleMesh mesh_;
  std::unique_ptr<const TriangleIndex> index_;
};

}  // namespace raycat
