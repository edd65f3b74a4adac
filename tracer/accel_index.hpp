#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>

#include "tracer/accel.hpp"
#include "tracer/light_passage.hpp"

namespace raycat {

/// The error of a coordinate in Embree's single precision, relative to it.
inline constexpr double float_ulp = 0x1p-23;

/// The coordinate that is greatest, whatever its sign.
inline double greatest(const glm::dvec3& v) { return glm::compMax(glm::abs(v)); }

/// One ray under way through Embree. The context comes first, so that callbacks find the rest.
struct AccelQuery {
  AccelQuery(const Ray& of, double end, Solid::Scratch& buffers)
      : ray(of), t_end(end), scratch(buffers) {}

  /// Keeps the solid's first boundary if it is closer than `t_end`, and tells whether it is.
  bool try_closest(const SolidObject& object);

  RTCIntersectContext context;
  const Ray& ray;
  double start = 0.0;  ///< where Embree's t = 0 is on the ray
  double t_end;
  Solid::Scratch& scratch;

  const SolidObject* solid = nullptr;  ///< the closest so far, and where it is met
  Boundary boundary;

  LightPassage* light = nullptr;  ///< of a shadow ray
};

/// The corners of a triangle in its mesh's own frame.
struct TriangleCorners {
  glm::dvec3 a, b, c;
};

TriangleCorners corners(const MeshInstance& instance, std::uint32_t triangle);

/// Embree's scene: triangles in float around the middle of the scene, and solids that are
/// evaluated in double when a ray comes near.
struct Accel::Index {
  /// Throws `std::length_error` for a scene past Embree's range, and `std::runtime_error` if
  /// Embree fails.
  explicit Index(const Scene& scene_in);

  /// Makes Embree's ray, from where `ray` enters the scene's box. False if it does not, or not
  /// before `query.t_end`.
  bool start(const Ray& ray, AccelQuery& query, RTCRay& out) const;

  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  const Scene& scene;
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device{rtcNewDevice(nullptr)};
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> embree;
  glm::dvec3 centre{0.0};  ///< of Embree's frame in the world
  Bounds box;              ///< around all that Embree holds, with room for rounding
  double padding = 0.0;    ///< what rounding a ray to float may move it within the box
  std::vector<const SolidObject*> bounded;
  std::vector<const SolidObject*> unbounded;

 private:
  void place();
  void add_mesh(const MeshInstance& instance);
  void add_solids();
};

}  // namespace raycat
