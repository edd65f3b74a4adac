#include "edges/edge_map.hpp"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

// A lattice of categories written row by row.
CategoryImage lattice(int width, int height, const std::vector<std::uint32_t>& categories) {
  CategoryImage image{.width = width, .height = height, .samples = {}, .table = {}};
  for (const std::uint32_t category : categories) {
    image.samples.push_back(image.table.intern(std::span(&category, 1)));
  }
  return image;
}

TEST_CASE("a pixel is an edge when its four samples are not all equal", "[edges]") {
  CHECK(detect_edges(lattice(1, 1, {5, 5, 5, 5})).count() == 0);
  CHECK(detect_edges(lattice(1, 1, {7, 5, 5, 5})).count() == 1);
  CHECK(detect_edges(lattice(1, 1, {5, 7, 5, 5})).count() == 1);
  CHECK(detect_edges(lattice(1, 1, {5, 5, 7, 5})).count() == 1);
  CHECK(detect_edges(lattice(1, 1, {5, 5, 5, 7})).count() == 1);
}

TEST_CASE("one odd sample marks the pixels whose square holds it (Fig. 6)", "[edges]") {
  const EdgeMap map = detect_edges(lattice(3, 3,
                                           {0, 0, 0, 0,  //
                                            0, 0, 0, 0,  //
                                            0, 0, 1, 0,  //
                                            0, 0, 0, 0}));
  const std::vector<std::uint8_t> expected{0, 0, 0,  //
                                           0, 1, 1,  //
                                           0, 1, 1};
  CHECK(map.pixels == expected);
  CHECK(map.at(2, 1));
  CHECK_FALSE(map.at(0, 1));
}

TEST_CASE("the last row and column of samples count", "[edges]") {
  CHECK(detect_edges(lattice(2, 1, {0, 0, 1, 0, 0, 1})).pixels == std::vector<std::uint8_t>{0, 1});
}

TEST_CASE("edges do not depend on the names of categories", "[edges]") {
  CHECK(rc::check("renaming", [] {
    const auto categories =
        *rc::gen::container<std::vector<std::uint32_t>>(42, rc::gen::inRange<std::uint32_t>(0, 3));
    std::vector<std::uint32_t> renamed;
    for (const std::uint32_t category : categories) {
      renamed.push_back(90 - 7 * category);
    }
    RC_ASSERT(detect_edges(lattice(6, 5, categories)).pixels ==
              detect_edges(lattice(6, 5, renamed)).pixels);
  }));
}

TEST_CASE("edges and textured pixels are selected for oversampling", "[edges][textures]") {
  CategoryImage image{.width = 3, .height = 1};
  image.samples.assign(8, CategoryId{0});
  EdgeMap edges{.width = 3, .height = 1, .pixels = {1, 0, 0}};
  CHECK(selected_pixels(edges, image).pixels == edges.pixels);
  // Samples of the lattice's last column and row are of no pixel.
  image.textured = {1, 1, 0, 1,  //
                    1, 1, 1, 1};
  CHECK(selected_pixels(edges, image).pixels == std::vector<std::uint8_t>{1, 1, 0});
  CHECK(textured_pixels(image) == 2);
}

}  // namespace
}  // namespace raycat
