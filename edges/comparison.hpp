#pragma once

#include <cstdint>

#include "categories/category_image.hpp"

namespace raycat {

/// What a method finds of an image's edges, against the heap method, whose categories are equal
/// exactly when the trees are (Table 1).
struct Comparison {
  std::uint64_t edge_pixels = 0;  ///< that the method selects
  std::uint64_t missed = 0;       ///< edge pixels of the heap method that it does not select

  /// Pairs of a pixel's sample and one of the three neighbours it is compared with (Fig. 6a) that
  /// differ by the heap method and not by this one.
  std::uint64_t false_equalities = 0;
  std::uint64_t distinct = 0;  ///< categories
};

/// Compares categories of the same samples, `heap` being by the heap method.
Comparison compare(const CategoryImage& method, const CategoryImage& heap);

}  // namespace raycat
