#include "geometry/continuation.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/edge_uses.hpp"
#include "threads/parallel.hpp"

namespace raycat {
namespace {

// Zero for a triangle whose height is nothing beside its longest side.
glm::dvec3 unit_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr double least_height = 1e-10;
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 bc = c - b;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double length = glm::length(normal);
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return length > least_height * longest ? normal / length : glm::dvec3(0.0);
}

}  // namespace

Continuation::Continuation(std::span<const glm::dvec3> positions,
                           std::span<const glm::uvec3> triangles,
                           std::span<const glm::vec3> normals, const FaceRule& rule, int threads)
    : positions_(positions),
      triangles_(triangles),
      normals_(normals),
      crease_(rule.crease),
      same_normal_(std::cos(rule.same_normal + crease_slack)),
      planes_(triangles.size()) {
  parallel_parts(planes_.size(), threads, [&](std::size_t begin, std::size_t end, int) {
    bool degenerate = false;
    for (std::size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = triangles_[i];
      planes_[i] = unit_normal(positions_[t.x], positions_[t.y], positions_[t.z]);
      degenerate = degenerate || planes_[i] == glm::dvec3(0.0);
    }
    if (degenerate) {
      some_degenerate_ = true;
    }
  });
}

bool Continuation::smooth(const TriangleSide& a, const TriangleSide& b, bool opposite) const {
  const double b_start = opposite ? b.to : b.from;
  const double b_end = opposite ? b.from : b.to;
  return same_normals(normal(a.half, a.from), normal(b.half, b_start)) &&
         same_normals(normal(a.half, a.to), normal(b.half, b_end));
}

double Continuation::tilt(std::uint32_t triangle) const {
  const glm::uvec3& t = triangles_[triangle];
  return rounding_tilt({positions_[t.x], positions_[t.y], positions_[t.z]});
}

// False if either is zero or not finite.
bool Continuation::same_normals(const glm::dvec3& a, const glm::dvec3& b) const {
  const double lengths = std::sqrt(glm::dot(a, a) * glm::dot(b, b));
  return lengths > 0.0 && std::isfinite(lengths) && glm::dot(a, b) >= same_normal_ * lengths;
}

// At a point of a half-edge, in parts of its length.
glm::dvec3 Continuation::normal(std::uint32_t half, double at) const {
  const glm::dvec3 from(normals_[half_edge_start(triangles_, half)]);
  const glm::dvec3 to(normals_[half_edge_end(triangles_, half)]);
  return at == 0.0 ? from : (at == 1.0 ? to : glm::mix(from, to, at));
}

}  // namespace raycat
