#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "csg/solid.hpp"
#include "tracer/scene.hpp"
#include "tracer/surface_layer.hpp"

namespace raycat {

/// Where a ray meets a surface of the scene.
struct Hit {
  double t = std::numeric_limits<double>::infinity();  ///< in units of the ray's direction
  SurfaceId surface{};
  MaterialId material{};
  bool entering = true;                ///< does the ray go into the object here?
  glm::dvec3 normal{0.0};              ///< unit, out of the object
  const MeshInstance* mesh = nullptr;  ///< null if a solid was hit
  std::uint32_t triangle = 0;
  glm::dvec2 barycentric{0.0};  ///< of the triangle's second and third corner
  bool sheet = false;           ///< is the triangle stored a second time, seen from behind?
  SurfaceLayer layer;
};

/// Finds what rays hit: one Embree scene of triangles, met again in double precision, and of
/// solids, evaluated in double (docs/design.md, Meshes). Unbounded solids are tried one by one.
/// Surfaces that lie in one are met in a fixed order (Coincident surfaces). Holds a reference to
/// the scene.
class Accel {
 public:
  explicit Accel(const Scene& scene);
  ~Accel();
  Accel(const Accel&) = delete;
  Accel& operator=(const Accel&) = delete;

  /// The first surface past t = 0, if there is one: none that the origin is on, but for those that
  /// a ray that departs from a hit has yet to pass, and no back face of a single-sided material.
  /// Start rays that leave a surface with `leave`.
  std::optional<Hit> closest(const Ray& ray, Solid::Scratch& scratch,
                             const Departure& from = {}) const;

  /// How much light passes from t = 0 to `t_end`: the product of the k_t of all surfaces
  /// between, zero behind an opaque one, whichever side of it faces the ray.
  glm::vec3 transmittance(const Ray& ray, double t_end, Solid::Scratch& scratch,
                          const Departure& from = {}) const;

  /// The surface that `ray` meets after `hit` at the same place, if there is one.
  std::optional<Hit> next_at(const Ray& ray, const Hit& hit, Solid::Scratch& scratch) const;

  /// A point by `hit`, on the side that `normal` points to, from which rays do not meet the same
  /// surface again. The offset follows from the error of the hit in double precision.
  glm::dvec3 leave(const Ray& ray, const Hit& hit, const glm::dvec3& normal) const;

  /// Where a ray of this direction starts that leaves the `hit` of another.
  Departure departure(const Ray& ray, const Hit& hit, const glm::dvec3& direction) const;

  const Scene& scene() const noexcept { return scene_; }

  struct Index;  ///< Embree's side, which its callbacks see

 private:
  const Scene& scene_;
  std::unique_ptr<Index> index_;
};

}  // namespace raycat
