#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/bounds.hpp"
#include "geometry/mesh.hpp"
#include "geometry/placed_shape.hpp"
#include "geometry/ray.hpp"
#include "geometry/surface_piece.hpp"

namespace raycat {

/// How far apart two surfaces within `whole` may be and still count as one, in scene units: 1e-7
/// of its half diagonal, but no less than coordinates so far from the origin are rounded by.
double coincidence_tolerance(const Bounds& whole);

/// Which pieces of surface of different parts lie in one surface (docs/design.md, Coincident
/// surfaces). A piece is what one equation describes, numbered as `Crossing::piece`: the faces of a
/// box, a cylinder or a cone, a ball, a half-space or a torus as a whole; a capsule's side (0),
/// lower (1) and upper ball (2); each triangle of a mesh.
///
/// Larger pieces come first. A piece joins the first surface that it is nowhere farther from than
/// the tolerance, measured across the surface, and otherwise makes a surface of its own: surfaces
/// are never chained together. Curved pieces join surfaces of their kind alone. What depends on
/// no direction from which it is seen can be decided once, so everything that asks where operands
/// coincide asks here.
class CoincidentSurfaces {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  /// Where a piece lies.
  struct Place {
    std::uint32_t surface = none;  ///< from 0; `none` where it shares it with nothing
    bool reversed = false;         ///< does it face the other way than the surface's largest piece?

    bool operator==(const Place&) const = default;
  };

  struct PieceId {
    std::uint32_t part = 0;
    std::uint32_t piece = 0;

    bool operator==(const PieceId&) const = default;
  };

  /// `whole` is a box around all that is bounded; `tolerance` is in scene units.
  CoincidentSurfaces(const Bounds& whole, double tolerance);

  /// Adds a part; parts are numbered from 0 in the order of these calls. Pieces whose boxes do
  /// not meet `where` are left out. Where a part has a smaller tolerance of its own, surfaces of it
  /// and of others may be no farther apart than that. The shape must stay where it is until `find`.
  void add(const PlacedShape& shape, const Bounds& where, double own_tolerance = unlimited);
  void add(PlacedShape&& shape, const Bounds& where, double own_tolerance = unlimited) = delete;
  /// As above. The mesh need not be closed, and must stay where it is until `find`.
  void add(const TriangleMesh& mesh, const Affine& transform, const Bounds& where,
           double own_tolerance = unlimited);

  /// To be called once, when all parts are added.
  void find();

  /// Is anything shared: does a surface hold pieces of two parts, or of one part that face opposite
  /// ways, where it is thinner than the tolerance?
  bool any() const noexcept { return !shared_.empty(); }

  std::uint32_t surfaces() const noexcept { return static_cast<std::uint32_t>(shared_.size()); }

  /// How far any piece is from the surface that it lies in, at most; as good as 0 where all that
  /// coincides does so but for rounding.
  double farthest() const noexcept { return farthest_; }

  /// The largest piece of a surface, which the surface is the one of.
  PieceId largest(std::uint32_t surface) const noexcept { return shared_[surface].largest; }

  /// Is it a plane?
  bool flat(std::uint32_t surface) const noexcept {
    return std::holds_alternative<Plane>(shared_[surface].shape);
  }

  /// Where the line passes through the surface, the same for each of its pieces: next to `t`, where
  /// it passes through one, `inwards` (of a curved surface) or not. Not a
  /// finite number if it never does.
  double passage(std::uint32_t surface, const Ray& ray, double t, bool inwards) const;

  Place place(std::uint32_t part, std::uint32_t piece) const noexcept {
    if (part >= first_place_.size() || first_place_[part] == nowhere) {
      return {};
    }
    return places_[first_place_[part] + piece];
  }

 private:
  struct Part {
    const PlacedShape* shape = nullptr;  // of a part that is no mesh
    const TriangleMesh* mesh = nullptr;  // of one that is
    std::uint32_t transform = 0;         // of a mesh, into `transforms_`
    double tolerance = 0.0;
    std::uint32_t pieces = 0;
  };
  struct Piece {
    float extent = 0.0f;
    PieceId id;
  };
  struct Surface {
    std::variant<Plane, CurvedSurface> shape;
    PieceId largest;
  };

  static constexpr std::size_t nowhere = ~std::size_t{0};

  void add_pieces(const Bounds& where);
  bool set(const Part& part, std::uint32_t piece, SurfacePiece& out) const;

  glm::dvec3 middle_{0.0};
  double size_ = 1.0;
  double tolerance_ = 0.0;
  // Until `find`.
  std::vector<Part> parts_;
  std::vector<Affine> transforms_;
  std::vector<Piece> pieces_;
  std::size_t planar_ = 0;  // of the pieces
  unsigned levels_ = 0;     // on which they are looked up, a bit each
  // From then on.
  std::vector<Place> places_;  // part by part, those parts that share anything
  std::vector<std::size_t> first_place_;
  std::vector<Surface> shared_;
  double farthest_ = 0.0;
};

}  // namespace raycat
