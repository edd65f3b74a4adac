#pragma once

#include <functional>

#include "categories/category_image.hpp"
#include "categories/detail.hpp"
#include "categories/encoder.hpp"

namespace raycat {

/// `image`, made with the heap encoder `heap`, in other words: `words_of(tree, words)` sets `words`
/// to those of a tree, which it may change, and is called once for each distinct tree. One trace
/// thus serves every level of detail and every method, but for `Detail::min_weight`, since heap
/// categories hold no weights. Throws `std::logic_error` for an encoder that is no heap.
CategoryImage recode(const CategoryImage& image, const Encoder& heap,
                     const std::function<void(RayTree& tree, CategoryWords& words)>& words_of);

/// `image`, of full detail, with the categories that `detail` keeps, in the words of `to`.
CategoryImage recode(const CategoryImage& image, const Encoder& heap, const Detail& detail,
                     const SurfaceTable& surfaces, const Encoder& to);

}  // namespace raycat
