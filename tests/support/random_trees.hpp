#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "raytree/ray_tree.hpp"

namespace raycat {

/// What the trees of a test are made of.
struct Forest {
  int levels = 6;
  int surfaces = 3;
  int lights = 2;
  bool refraction = true;
};

/// Every tree of `forest` once, the empty one first. There are T(n) = 1 + s 2^l T(n-1)^2 of n
/// levels, s surfaces and l lights, the square being of refraction.
inline std::vector<RayTree> all_trees(const Forest& forest, HeapPosition position = root) {
  std::vector<RayTree> trees{{}};
  if (level(position) > forest.levels) {
    return trees;
  }
  const std::vector<RayTree> reflections = all_trees(forest, reflected(position));
  const std::vector<RayTree> refractions =
      forest.refraction ? all_trees(forest, refracted(position)) : std::vector<RayTree>{{}};
  for (const RayTree& refraction : refractions) {
    for (const RayTree& reflection : reflections) {
      RayTree tree(refraction);
      tree.insert(tree.end(), reflection.begin(), reflection.end());
      tree.emplace_back();
      for (LightMask lights = 0; lights < LightMask{1} << forest.lights; ++lights) {
        for (int s = 0; s < forest.surfaces; ++s) {
          tree.back() = {.position = position,
                         .lights = lights,
                         .surface = SurfaceId{static_cast<std::uint32_t>(s)}};
          trees.push_back(tree);
        }
      }
    }
  }
  return trees;
}

/// From 0 to n - 1, drawn within a RapidCheck property and, unlike `inRange` alone, as often at a
/// property's first trials as at its last.
template <typename T>
T draw_below(T n) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(T{0}, n));
}

inline void relabel(const Forest& forest, RayNode& node) {
  node.lights = draw_below(LightMask{1} << forest.lights);
  node.surface = SurfaceId{draw_below(static_cast<std::uint32_t>(forest.surfaces))};
}

inline void grow(const Forest& forest, HeapPosition position, RayTree& tree) {
  if (level(position) < forest.levels) {
    // About one child a node, so that trees are of all sizes.
    if (forest.refraction && draw_below(100) < 55) {
      grow(forest, refracted(position), tree);
    }
    if (draw_below(100) < (forest.refraction ? 55 : 80)) {
      grow(forest, reflected(position), tree);
    }
  }
  tree.push_back({.position = position});
  relabel(forest, tree.back());
}

/// A tree of `forest`, drawn within a RapidCheck property.
inline RayTree draw_tree(const Forest& forest) {
  RayTree tree;
  if (draw_below(16) != 0) {
    grow(forest, root, tree);
  }
  return tree;
}

/// Moves some branches that have no sibling to the other side. The list stays that of a tree.
inline void swing(RayTree& tree) {
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const HeapPosition from = tree[i].position;
    const bool alone = from != root && std::ranges::none_of(tree, [&](const RayNode& node) {
                         return node.position == (from ^ 1);
                       });
    if (!alone || draw_below(2) == 0) {
      continue;
    }
    for (RayNode& node : tree) {
      const int below = level(node.position) - level(from);
      if (below >= 0 && node.position >> below == from) {
        node.position ^= HeapPosition{1} << below;
      }
    }
  }
}

/// Two trees of `forest` that are often alike: the same; with one node, or two nodes' places,
/// changed (Fig. 3); with branches moved to the other side (Fig. 4).
inline std::pair<RayTree, RayTree> draw_pair(const Forest& forest) {
  RayTree a = draw_tree(forest);
  RayTree b(a);
  const int kind = draw_below(5);
  if (kind == 1 && !b.empty()) {
    relabel(forest, b[draw_below(b.size())]);
  } else if (kind == 2 && !b.empty()) {
    RayNode& one = b[draw_below(b.size())];
    RayNode& other = b[draw_below(b.size())];
    std::swap(one.lights, other.lights);
    std::swap(one.surface, other.surface);
  } else if (kind == 3 && forest.refraction) {
    swing(b);
  } else if (kind == 4) {
    b = draw_tree(forest);
  }
  return {std::move(a), std::move(b)};
}

}  // namespace raycat
