#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "raytree/surface_id.hpp"

namespace raycat {

/// Place of a node in the ray tree, numbered as in a binary heap (Fig. 5): the camera ray's
/// own hit is 1, a node under `p` is 2p if refraction led to it and 2p + 1 if reflection did.
using HeapPosition = std::uint64_t;

/// Lights that reach a hit: bit i is set when light i of the scene does. Up to 64 lights.
using LightMask = std::uint64_t;

inline constexpr HeapPosition root = 1;
inline constexpr int most_levels = 64;
inline constexpr int most_lights = 64;

constexpr HeapPosition refracted(HeapPosition p) noexcept { return 2 * p; }
constexpr HeapPosition reflected(HeapPosition p) noexcept { return 2 * p + 1; }

/// Level of a position: 1 at the root, at most 64.
constexpr int level(HeapPosition p) noexcept { return static_cast<int>(std::bit_width(p)); }

/// One intersection on the way of a pixel's ray.
struct RayNode {
  HeapPosition position = root;
  LightMask lights = 0;
  SurfaceId surface{};

  /// The most this node's colour can count for in the pixel: the product of the k_s and k_t on
  /// the way to it, greatest channel. Factors only, so that it does not vary over a surface: of
  /// Fresnel's reflection, what it is at normal incidence. Not part of the category: it is for
  /// `reduce`.
  float weight = 1.0f;

  /// Are these the same node of a category?
  friend constexpr bool operator==(const RayNode& a, const RayNode& b) noexcept {
    return a.position == b.position && a.lights == b.lights && a.surface == b.surface;
  }
};

/// The tree of one pixel's ray, flattened in the order its intersections are finished:
/// refraction subtree, reflection subtree, node. Empty when the ray leaves the scene.
///
/// Positions make the list a faithful picture of the tree, so two rays have the same category
/// (Section 2.1) exactly when their lists are equal.
using RayTree = std::vector<RayNode>;

/// What the tracer needs of a place to put the nodes it meets. A `RayTree` is one.
template <typename R>
concept Recorder = requires(R& recorder, const RayNode& node) {
  recorder.push_back(node);
};

/// Records nothing, for images without categories.
struct NoRecord {
  constexpr void push_back(const RayNode&) const noexcept {}
};

}  // namespace raycat
