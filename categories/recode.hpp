#pragma once

#include <functional>

#include "categories/category_trees.hpp"

namespace raycat {

/// The image of `trees` in other words: `words_of(tree, words)` sets `words` to those of a tree,
/// and is called once for each distinct tree. One trace thus serves every method. No encoder is
/// said to have made them.
CategoryImage recode(
    CategoryTrees& trees,
    const std::function<void(const RayTree& tree, CategoryWords& words)>& words_of);

/// The image of `trees`, of full detail, with the categories that `detail` keeps, in the words of
/// `to`. One trace thus serves every level of detail, but for `Detail::min_weight`, since
/// categories hold no weights.
CategoryImage recode(CategoryTrees& trees, const Detail& detail, const SurfaceTable& surfaces,
                     const Encoder& to);

}  // namespace raycat
