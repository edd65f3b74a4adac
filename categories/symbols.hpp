#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "categories/category.hpp"
#include "raytree/ray_tree.hpp"

namespace raycat {

/// The ids of Section 2.1: sequential natural numbers from 1, lights before surfaces, since lights
/// are met most often and small ids make small numbers (Section 2.1.2).
class Symbols {
 public:
  explicit Symbols(const Extent& scene) : lights_(static_cast<std::uint32_t>(scene.lights)) {}

  std::uint32_t light(int i) const noexcept { return 1 + static_cast<std::uint32_t>(i); }
  std::uint32_t surface(SurfaceId id) const noexcept {
    return 1 + lights_ + static_cast<std::uint32_t>(id);
  }

  /// Calls `take(symbol)` for each symbol of `tree` in the order of Figs. 3 to 5: nodes as they are
  /// listed, children first, and of each node its surface, then the lights that reach it.
  template <typename Take>
  void list(std::span<const RayNode> tree, const Take& take) const {
    for (const RayNode& node : tree) {
      take(surface(node.surface));
      for (LightMask left = node.lights; left != 0; left &= left - 1) {
        take(light(std::countr_zero(left)));
      }
    }
  }

 private:
  std::uint32_t lights_;
};

}  // namespace raycat
