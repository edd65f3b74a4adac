#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"
#include "geometry/placed_shape.hpp"
#include "geometry/ray.hpp"

namespace raycat {

// Positions here are relative to some point of the world near the surfaces that are compared, so
// that far ones lose no precision.

/// The points p with dot(normal, p) = offset.
struct Plane {
  glm::dvec3 normal{0.0};  ///< unit
  double offset = 0.0;

  double distance(const glm::dvec3& point) const noexcept;

  /// Where the line passes through it; not finite if it never does.
  double passage(const Ray& line) const noexcept;
};

/// The image of a surface of revolution around Y.
struct CurvedSurface {
  enum class Kind : std::uint8_t {
    ball,   ///< of a radius, at a height
    cone,   ///< of a radius at height 0, and its slope: a cylinder, or a cone on this side of its
            ///< apex, without end
    torus,  ///< of a radius, and that of its tube
  };

  Kind kind = Kind::ball;
  double radius = 1.0;
  double other = 0.0;       ///< height, slope or tube
  glm::dmat3 inverse{1.0};  ///< to the surface's frame, after `origin` is taken away
  glm::dvec3 origin{0.0};
  glm::dvec3 middle{0.0};  ///< of a ball or a torus; the point of a cone's axis next to 0
  glm::dvec3 axis{0.0};    ///< unit, either way; 0 for a ball
  double spread = 0.0;     ///< of a ball, its radius unless it is stretched

  /// To first order: |f| / |grad f|, with the f that is a distance in the surface's own frame.
  double distance(const glm::dvec3& point) const noexcept;

  /// Where the line passes through it inwards or outwards, next to `t`; not finite if it never
  /// does. Depends on `t` no further.
  double passage(const Ray& line, double t, bool inwards) const;
};

/// A piece of a surface, as `CoincidentSurfaces` has them. One is reused from piece to piece.
struct SurfacePiece {
  bool planar = true;
  Plane plane;           ///< if planar; the normal points outwards
  CurvedSurface curved;  ///< if not
  double extent = 0.0;   ///< about its area; infinite for a half-space
  double width = 0.0;    ///< across its narrow side
  /// So dense that a surface of its kind that is near all of them is near the piece.
  std::vector<glm::dvec3> samples;
};

/// How many pieces the shape has: numbers of `Crossing::piece`.
std::uint32_t piece_count(const Shape& shape);

/// Sets `out` to a piece of a shape, relative to `from`. Returns false if there is nothing of it.
/// A half-space is looked at up to `reach` around `from`.
bool set_piece(const PlacedShape& shape, std::uint32_t piece, const glm::dvec3& from, double reach,
               SurfacePiece& out);

/// Sets `out` to a triangle, relative to `from`. Returns false if it has no area.
bool set_triangle(const TriangleMesh& mesh, std::uint32_t triangle, const Affine& transform,
                  const glm::dvec3& from, SurfacePiece& out);

}  // namespace raycat
