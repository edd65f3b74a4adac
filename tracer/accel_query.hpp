#pragma once

#include <cstdint>
#include <optional>

#include <embree3/rtcore.h>

#include "tracer/accel.hpp"
#include "tracer/light_passage.hpp"

namespace raycat {

/// Where a ray meets the plane of a triangle, in double precision. Nothing is set by itself: there
/// is one in every query, few of which need it.
struct TriangleMet {
  const MeshInstance* instance;
  std::uint32_t triangle;
  double t;
  double rise;  ///< distance from the plane that the ray gains while t grows by 1
  bool entering;
  bool inside;  ///< of the triangle, to the last digits
  bool sheet;   ///< as `Hit::sheet`
  glm::dvec2 barycentric;
  glm::dvec3 normal;  ///< in the mesh's frame, of any length

  MeshPoint point() const {
    return {.mesh = *instance->mesh, .triangle = triangle, .barycentric = barycentric};
  }
};

/// Where Embree has a ray meet a triangle, in single precision.
struct FloatMet {
  const MeshInstance* instance;
  std::uint32_t triangle;
  double t;
  double rise;    ///< as of `TriangleMet`
  bool entering;  ///< wrong at most where the ray nearly goes along the plane
};

/// None if the ray lies in the triangle's plane, or along it, and for a copy of another triangle;
/// of two that are wound opposite ways, the one that faces the ray.
std::optional<TriangleMet> meet(const MeshInstance& instance, std::uint32_t triangle,
                                const Ray& ray);

/// One ray under way: what of all that it comes by it meets, and what of that first, or what it
/// leaves of light. The context comes first, so that Embree's callbacks find the rest.
class AccelQuery {
 public:
  AccelQuery(const Accel::Index& index, const Ray& ray, const Departure& from, double end,
             Solid::Scratch& scratch);

  /// Offers a surface to a ray that looks for the first. True if it is the first so far.
  bool offer(const SolidObject& object);
  bool offer(const TriangleMet& met);
  bool offer(const FloatMet& met);

  /// Weakens the light by what the ray meets of it; false if nothing is left.
  bool shade(const SolidObject& object, LightPassage& out);
  /// `near` as for `LightPassage::first_of_passage`.
  bool shade(const TriangleMet& met, LightPassage& out, double near);
  bool shade(const FloatMet& met, LightPassage& out, double near);

  /// The first.
  std::optional<Hit> first();

  /// Does the ray start on this triangle?
  bool leaves(const MeshInstance* mesh, std::uint32_t triangle) const noexcept {
    return from_.mesh == mesh && from_.triangle == triangle;
  }

  /// How far Embree's ray needs to look: up to the first so far and by what may be wrong there.
  float reach() const;

  const Ray& ray() const noexcept { return ray_; }
  double t_end() const noexcept { return t_end_; }

  RTCIntersectContext context;
  LightPassage* light = nullptr;  ///< of a shadow ray
  double begin = 0.0;             ///< from which t on surfaces may be met
  double embree_start = 0.0;      ///< where on the ray Embree's begins

 private:
  SurfaceLayer layer(const SolidObject& object, const Boundary& boundary) const;
  SurfaceLayer layer(const TriangleMet& met) const;
  double rise(const SolidObject& object, const Boundary& boundary) const;
  template <typename Rise>
  bool meets(double t, bool entering, const SurfaceLayer& layer, const Rise& rise) const;
  bool meets(const TriangleMet& met) const;
  bool closer(double t, bool entering, const SurfaceLayer& layer, double rise) const;
  template <typename Seen>
  void each_boundary(const SolidObject& object, const Seen& seen);

  bool plain(const FloatMet& met) const;
  void settle();

  enum class Kind { none, solid, triangle, in_float };

  const Accel::Index& index_;
  const Ray& ray_;
  const Departure& from_;
  Solid::Scratch& scratch_;
  double length2_;  // of the direction, squared

  // The first so far: of one kind, the others are not set.
  Kind kind_ = Kind::none;
  double t_end_;
  double slack_ = 0.0;  // up to where before and beyond it, in t, something is not known to be so
  SurfaceLayer first_layer_;
  bool first_along_ = true;  // the normal of its layer's surface
  const SolidObject* solid_;
  Boundary boundary_;
  TriangleMet triangle_;
  FloatMet in_float_;
};

}  // namespace raycat
