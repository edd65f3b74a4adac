#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "categories/category_image.hpp"
#include "edges/edge_map.hpp"
#include "edges/regions.hpp"
#include "tracer/image.hpp"

namespace raycat {

/// Edge pixels white on black.
Image edge_image(const EdgeMap& edges);

/// Edge pixels black on white: line art (Section 6, Fig. 15).
Image line_image(const EdgeMap& edges);

/// `picture` with its edge pixels painted black, as in Figs. 9 and 10.
Image overlay_image(const Image& picture, const EdgeMap& edges);

/// Each pixel in the colour of its sample's category, `colours` being by number, linear RGB.
Image painted(const CategoryImage& categories, const std::vector<glm::vec3>& colours);

/// Each pixel in the colour of its sample's category (Fig. 7f). The colour is a hash of the
/// category itself, so a category keeps it from view to view of one scene; where the ray leaves
/// the scene it is white.
Image segment_image(const CategoryImage& categories);

/// Each pixel in the colour of its region. The first region of a category, in raster order, has
/// the category's colour in `segment_image`; the others have hashes of it and their ordinal, so
/// that they stay in other colours however many regions the rest of the image has.
Image region_image(const CategoryImage& categories, const Regions& regions);

}  // namespace raycat
