#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "categories/category_image.hpp"

namespace raycat {

enum class RegionId : std::uint32_t {};

/// The connected parts of an image's categories, numbered from 0 in raster order of their first
/// pixels.
struct Regions {
  int width = 0;
  int height = 0;
  std::vector<RegionId> labels;        ///< width * height, rows from the top
  std::vector<std::uint64_t> sizes;    ///< in pixels, by region
  std::vector<CategoryId> categories;  ///< by region

  std::size_t count() const noexcept { return sizes.size(); }

  RegionId at(int x, int y) const {
    return labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Joins pixels that share a side and a category: segmentation into regions (Section 1), each of
/// which is part of one equivalence class of Section 2. A pixel has its own sample's category, so
/// the lattice's last row and column belong to no region. Throws `std::length_error` past
/// 2^32 - 1 pixels.
Regions connected_regions(const CategoryImage& categories);

}  // namespace raycat
