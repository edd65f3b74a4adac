#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>

#include "geometry/triangle_index.hpp"
#include "tracer/accel.hpp"
#include "tracer/surface_layers.hpp"

namespace raycat {

class AccelQuery;

/// The error of a coordinate in Embree's single precision, relative to it.
inline constexpr double float_ulp = 0x1p-23;

/// The coordinate that is greatest, whatever its sign.
inline double greatest(const glm::dvec3& v) { return glm::compMax(glm::abs(v)); }

/// The corners of a triangle in its mesh's own frame.
struct TriangleCorners {
  glm::dvec3 a, b, c;
};

TriangleCorners corners(const MeshInstance& instance, std::uint32_t triangle);

/// Embree's scene: triangles in float around the middle of the scene, met again in double, and
/// solids, and meshes too small for float where they are, evaluated in double when a ray comes
/// near.
struct Accel::Index {
  /// Throws `std::length_error` for a scene past Embree's range, and `std::runtime_error` if
  /// Embree fails.
  explicit Index(const Scene& scene_in);

  /// Makes Embree's ray, from where the query's enters the scene's box. False if it does not, or
  /// not before the query's end.
  bool start(AccelQuery& query, RTCRay& out) const;

  /// How wrong Embree may be about what small triangles do at a point of the world.
  double float_error(const glm::dvec3& point) const {
    return 8 * float_ulp * greatest(point - centre);
  }

  /// How near a surface is that a ray from `origin` starts on.
  double on_surface(const glm::dvec3& origin) const;

  /// How far from a hit at `point` rays start that leave it, seen from `origin`.
  double leave_distance(const glm::dvec3& origin, const glm::dvec3& point, bool of_triangle) const;

  struct Release {
    void operator()(RTCDevice released) const { rtcReleaseDevice(released); }
    void operator()(RTCScene released) const { rtcReleaseScene(released); }
  };

  // A mesh that Embree does not see the triangles of.
  struct SmallMesh {
    const MeshInstance* instance;
    std::shared_ptr<const TriangleIndex> triangles;
  };

  const Scene& scene;
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device{rtcNewDevice(nullptr)};
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> embree;
  glm::dvec3 centre{0.0};  ///< of Embree's frame in the world
  Bounds box;              ///< around all that Embree holds, with room for rounding
  double padding = 0.0;    ///< what rounding a ray to float may move it within the box
  double farthest = 0.0;   ///< greatest coordinate within the box
  double near2 = 1e-12;    ///< nearer to its start than the root of it, a ray takes care
  std::vector<std::uint8_t> needs_double;  ///< of which meshes every hit is found in double at once
  std::vector<const SolidObject*> bounded;
  std::vector<const SolidObject*> unbounded;
  std::vector<Bounds> mesh_bounds;  ///< in the world
  std::vector<SmallMesh> small_meshes;
  SurfaceLayers layers;

 private:
  void place_frame();
  void add_meshes();
  void add_mesh(std::size_t number, const MeshInstance& instance);
  void add_user_geometry(std::size_t count, RTCBoundsFunction bounds,
                         RTCIntersectFunctionN intersect, RTCOccludedFunctionN occluded);
};

}  // namespace raycat
