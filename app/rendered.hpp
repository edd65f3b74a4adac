#pragma once

#include <optional>

#include "antialias/antialias.hpp"
#include "categories/category_trees.hpp"
#include "edges/edge_classes.hpp"
#include "edges/edge_map.hpp"
#include "edges/refine.hpp"
#include "edges/regions.hpp"
#include "render/coverage.hpp"
#include "render/render.hpp"

namespace raycat::app {

/// All that `raycat render` makes, before it is written.
struct Rendered {
  Rendered() = default;
  Rendered(const Rendered&) = delete;  // the trees are of the categories beside them
  Rendered& operator=(const Rendered&) = delete;

  std::optional<Rendering> categorized;  ///< or without categories:
  Image colour{0, 0};
  std::optional<AntialiasedPicture> antialiased;  ///< of the picture, which is then in `colour`
  std::optional<CoverageImage> coverage;
  RayCounts rays;

  std::optional<CategoryTrees> trees;  ///< of `categorized`, if it is there
  EdgeMap edges;
  EdgeMap selected;
  std::optional<RefinedEdges> refined;
  std::optional<EdgeClasses> classes;
  std::optional<Regions> regions;

  const Image& picture() const {
    return categorized && !antialiased ? categorized->colour : colour;
  }
  const CategoryImage& categories() const { return categorized->categories; }

  /// Edges as finely as they were asked for.
  const EdgeMap& finest_edges() const { return refined ? refined->map : edges; }
};

}  // namespace raycat::app
