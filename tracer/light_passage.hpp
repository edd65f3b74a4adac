#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>

#include <glm/vec3.hpp>

#include "csg/solid.hpp"
#include "tracer/scene.hpp"

namespace raycat {

/// What is left of light on its way along a ray to `t_end`, told of what it meets in any order.
class LightPassage {
 public:
  LightPassage(const Ray& ray, double t_end) : ray_(ray), t_end_(t_end) {}

  double t_end() const noexcept { return t_end_; }

  /// Weakens the light by a surface with this transmission.
  void through(const glm::vec3& transmission) { light_ *= transmission; }

  /// Weakens the light by a stretch of the way that is inside of an object.
  void absorb(const glm::vec3& absorption, double begin, double end);

  /// Weakens the light by a surface of a mesh that absorbs inside, of which surfaces are told in
  /// any order.
  void through(const glm::vec3& transmission, const glm::vec3& absorption, bool entering, double t);

  /// Is this the first triangle reported of one passage into a mesh or out of it? At an edge both
  /// are. Passages closer than `near` are one.
  bool first_of_passage(std::size_t mesh, bool entering, double t, double near);

  bool stopped() const noexcept { return light_ == glm::vec3(0.0f); }

  /// The share of each channel that arrives.
  glm::vec3 left() const;

 private:
  using Passage = std::pair<std::size_t, double>;  // mesh and whether it is entered, and t

  // For one end of a stretch inside.
  void cross(const glm::vec3& absorption, bool entering, double t) {
    const glm::dvec3 more = entering ? glm::dvec3(absorption) : -glm::dvec3(absorption);
    open_ += more;
    depth_ -= t * more;
  }

  const Ray& ray_;
  double t_end_;
  glm::vec3 light_{1.0f};  // that surfaces have let through

  // What is absorbed on the way: the absorption of each stretch inside times its length. Triangles
  // come in any order, so each adds its own part; `open_` is of the meshes that the ray ends inside
  // of.
  glm::dvec3 depth_{0.0};
  glm::dvec3 open_{0.0};

  // The first passages, of which rays seldom have more, and then the others in order.
  std::array<Passage, 16> first_;  // as many as `count_`; the rest is not even cleared
  std::size_t count_ = 0;
  std::unique_ptr<std::set<Passage>> others_;  // null while there are none
};

}  // namespace raycat
