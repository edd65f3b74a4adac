#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "csg/prefetch.hpp"
#include "csg/tree.hpp"
#include "geometry/crossing.hpp"
#include "geometry/ray.hpp"
#include "geometry/shape.hpp"

namespace raycat {

/// What rays need of a tree's leaves, each within one cache line: large trees are waited for more
/// than computed. Leaves that are turned or scaled alike share the matrix.
class PackedLeaves {
 public:
  explicit PackedLeaves(std::span<const CsgLeaf> leaves);

  /// As `PlacedShape::cross_local` of that leaf's shape.
  bool cross_local(std::uint32_t leaf, const Ray& world, Crossings& out) const {
    const Leaf& packed = leaves_[leaf];
    Ray local{.origin = world.origin - packed.translation, .direction = world.direction};
    if (packed.linear != identity) {
      const glm::dmat3& inverse = inverses_[packed.linear];
      local = {.origin = inverse * local.origin, .direction = inverse * local.direction};
    }
    return raycat::cross(packed.shape, local, out);
  }

  void prefetch(std::uint32_t leaf) const noexcept { raycat::prefetch(&leaves_[leaf]); }

 private:
  struct alignas(64) Leaf {
    Shape shape;
    glm::dvec3 translation{0.0};
    std::uint32_t linear = 0;  // into `inverses_`, or `identity`
  };
  static_assert(sizeof(Leaf) == 64);

  static constexpr std::uint32_t identity = ~std::uint32_t{0};

  std::vector<Leaf> leaves_;
  std::vector<glm::dmat3> inverses_;
};

}  // namespace raycat
