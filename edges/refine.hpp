#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "edges/edge_map.hpp"

namespace raycat {

/// The categories of points of the image, in the order of `points`. Points are in lattice units:
/// sample (x, y) of a `CategoryImage` is at (x, y), which is the centre of pixel (x, y). The ids
/// are those of the image's own table, which may grow for them.
using CategorySampler = std::function<std::vector<CategoryId>(std::span<const glm::dvec2> points)>;

inline constexpr int most_subpixel_levels = 6;

/// Edges at subpixels, and what they cost.
struct RefinedEdges {
  EdgeMap map;                ///< 2^levels subpixels a pixel each way
  std::uint64_t sampled = 0;  ///< points asked of the sampler
};

/// Breaks each edge pixel into four subpixels, compares these as pixels are compared, and so on
/// `levels` times, at most `most_subpixel_levels` (Section 3, Fig. 6b). A subpixel is marked if
/// its four corners, each a sample, are not all of one category and the square it was broken out
/// of was marked too. Every marked square holds a marked subpixel, since its four share corners.
///
/// `sample` is called once a level at most, with the new points of that level in raster order,
/// each once though neighbours share it; so it may work on them in parallel. Needs memory for
/// the edge squares of two levels, and a byte a subpixel for the map. Throws `std::length_error`
/// if the map would be 2^31 subpixels wide or high.
RefinedEdges refine_edges(const CategoryImage& categories, int levels,
                          const CategorySampler& sample);

}  // namespace raycat
