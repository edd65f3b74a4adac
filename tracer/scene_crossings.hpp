#pragma once

#include <memory>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// A passage of a line through the surface of an object of the scene.
struct SceneCrossing {
  double t = 0.0;  ///< in units of the ray's direction
  SurfaceId surface{};
  bool entering = true;
  glm::dvec3 normal{0.0};  ///< unit, out of the object
};

/// Finds all passages of a line through every object of a scene: for measuring and for probing,
/// where images want the first only. Holds a reference to the scene.
class SceneCrossings {
 public:
  explicit SceneCrossings(const Scene& scene);

  /// Sets `out` to every crossing with the whole line, in ascending t. Set operations are
  /// applied; of meshes every triangle counts, so open ones need not alternate.
  void cross(const Ray& ray, Solid::Scratch& scratch, std::vector<SceneCrossing>& out) const;

 private:
  struct Indexed;

  const Scene& scene_;
  std::vector<std::shared_ptr<const Indexed>> meshes_;  // one an instance
};

}  // namespace raycat
