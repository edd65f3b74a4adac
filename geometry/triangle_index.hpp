#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/bounds.hpp"
#include "geometry/crossing.hpp"
#include "geometry/mesh.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// Finds the triangles that a line goes through, exactly: a line through an edge or a vertex
/// counts as if moved aside by an infinitely small amount, the same for all triangles, so that
/// each passage through a surface counts once.
class TriangleIndex {
 public:
  /// One triangle that the line goes through.
  struct Passage {
    double t = 0.0;     ///< from `Passages::near` on
    double area = 0.0;  ///< of the triangle as the line sees it
    std::uint32_t triangle = 0;
    int turn = 1;  ///< how the winding number changes: 1 entering, -1 leaving
  };

  struct Passages {
    Ray near;                   ///< the ray, started at the point of the bounds next to its origin
    double t_shift = 0.0;       ///< where that is on the ray
    double tolerance = 0.0;     ///< passages closer than this are in an order rounding decided
    std::vector<Passage> list;  ///< in ascending t
  };

  /// Refers to `mesh`, which must stay where it is. Its indices must be in range. Throws
  /// `std::runtime_error` if memory runs out.
  explicit TriangleIndex(const TriangleMesh& mesh);
  ~TriangleIndex();
  TriangleIndex(const TriangleIndex&) = delete;
  TriangleIndex& operator=(const TriangleIndex&) = delete;

  const Bounds& bounds() const noexcept { return bounds_; }

  /// Sets `out` to all passages of the whole line. The direction must be finite and not zero.
  void pass(const Ray& ray, Passages& out) const;

  /// Appends every passage as a crossing, ascending: of an open mesh they need not alternate.
  void cross(const Ray& ray, Crossings& out) const;

  /// The normal of the triangle passed, against `direction` where the line enters and along it
  /// where it leaves. Any positive length.
  glm::dvec3 outward_normal(const Passage& passage, const glm::dvec3& direction) const;

 private:
  struct Tree;  // Embree's, for meshes of more than a few triangles

  const TriangleMesh& mesh_;
  Bounds bounds_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace raycat
