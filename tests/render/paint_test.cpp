#include "render/paint.hpp"

#include <set>
#include <tuple>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

const glm::vec3 black(0.0f), white(1.0f);
const EdgeMap map{.width = 2, .height = 1, .pixels = {1, 0}};

TEST_CASE("edges are white on black, lines black on white", "[edges][paint]") {
  CHECK(edge_image(map).pixels == std::vector{white, black});
  CHECK(line_image(map).pixels == std::vector{black, white});
}

TEST_CASE("an overlay changes edge pixels and no others", "[edges][paint]") {
  Image picture(2, 1, glm::vec3(0.25f));
  CHECK(overlay_image(picture, map).pixels == std::vector{black, glm::vec3(0.25f)});
}

CategoryImage row(const std::vector<std::vector<std::uint32_t>>& categories) {
  CategoryImage image{
      .width = static_cast<int>(categories.size()) - 1, .height = 0, .samples = {}, .table = {}};
  for (const auto& words : categories) {
    image.samples.push_back(image.table.intern(words));
  }
  const auto first = image.samples;
  image.samples.insert(image.samples.end(), first.begin(), first.end());
  image.height = 1;
  return image;
}

TEST_CASE("a category has one colour in every picture of its scene", "[edges][paint]") {
  const Image a = segment_image(row({{1}, {2}, {1}, {3}, {}}));
  const Image b = segment_image(row({{3}, {1}, {2}, {1}}));
  CHECK(a.pixels[0] == a.pixels[2]);
  CHECK(a.pixels[0] == b.pixels[1]);
  CHECK(a.pixels[1] == b.pixels[2]);
  CHECK(a.pixels[3] == b.pixels[0]);
  CHECK(a.pixels[0] != a.pixels[1]);
}

TEST_CASE("the empty category is white", "[edges][paint]") {
  CHECK(segment_image(row({{}, {4}, {4}})).pixels[0] == white);
}

TEST_CASE("a hundred categories have nearly a hundred colours", "[edges][paint]") {
  std::vector<std::vector<std::uint32_t>> categories;
  for (std::uint32_t i = 0; i <= 100; ++i) {
    categories.push_back({0x01000000u | i});
  }
  std::set<std::tuple<float, float, float>> colours;
  for (const glm::vec3& pixel : segment_image(row(categories)).pixels) {
    colours.emplace(pixel.r, pixel.g, pixel.b);
  }
  CHECK(colours.size() >= 99);
}

// One row of pixels, with a row and a column of samples more.
Image regions_painted(const std::vector<std::vector<std::uint32_t>>& categories) {
  const CategoryImage image = row(categories);
  return region_image(image, connected_regions(image));
}

TEST_CASE("regions of one category have colours of their own", "[edges][paint]") {
  const Image image = regions_painted({{1}, {1}, {2}, {1}, {2}, {1}, {}, {9}});
  CHECK(image.pixels[0] == image.pixels[1]);
  std::set<std::tuple<float, float, float>> colours;
  for (const glm::vec3& pixel : image.pixels) {
    colours.emplace(pixel.r, pixel.g, pixel.b);
  }
  CHECK(colours.size() == 6);  // three regions of 1, two of 2, and white
}

TEST_CASE("a region's colour depends on its category and ordinal alone", "[edges][paint]") {
  const Image a = regions_painted({{1}, {2}, {1}, {9}});
  const Image b = regions_painted({{3}, {1}, {4}, {5}, {1}, {9}});
  CHECK(a.pixels[0] == b.pixels[1]);
  CHECK(a.pixels[2] == b.pixels[4]);
  CHECK(a.pixels[0] == segment_image(row({{1}, {9}})).pixels[0]);
}

TEST_CASE("where rays leave the scene the first region is white, others are not",
          "[edges][paint]") {
  const Image image = regions_painted({{}, {2}, {}, {9}});
  CHECK(image.pixels[0] == white);
  CHECK(image.pixels[2] != white);
  CHECK(image.pixels[2] != image.pixels[1]);
}

}  // namespace
}  // namespace raycat
