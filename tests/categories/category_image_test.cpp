#include "categories/category_image.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// Two pixels wide and one high, so three samples by two.
CategoryImage small(const std::vector<std::uint32_t>& samples) {
  CategoryImage image{.width = 2, .height = 1};
  for (const std::uint32_t sample : samples) {
    image.samples.push_back(image.table.intern(CategoryWords{sample}));
  }
  return image;
}

TEST_CASE("samples are rows from the top, one more a row than pixels", "[categories][image]") {
  const CategoryImage image = small({0, 1, 2, 3, 4, 5});
  CHECK(image.at(0, 0) == CategoryId{0});
  CHECK(image.at(2, 0) == CategoryId{2});
  CHECK(image.at(0, 1) == CategoryId{3});
  CHECK(image.at(2, 1) == CategoryId{5});
}

TEST_CASE("pixels are counted by the category of their own sample", "[categories][image]") {
  // The samples of the last row and column are no pixel's own.
  CHECK(pixels_per_category(small({7, 8, 9, 9, 9, 9})) == std::vector<std::uint64_t>{1, 1, 0});
  CHECK(pixels_per_category(small({7, 7, 9, 9, 9, 9})) == std::vector<std::uint64_t>{2, 0});
}

TEST_CASE("only pixels count as textured, not the samples beyond them", "[categories][image]") {
  CategoryImage image = small({0, 0, 0, 0, 0, 0});
  CHECK(textured_pixels(image) == 0);
  image.textured = {0, 0, 1, 1, 1, 1};
  CHECK(textured_pixels(image) == 0);
  image.textured = {1, 0, 0, 0, 0, 0};
  CHECK(textured_pixels(image) == 1);
  image.textured = {1, 1, 1, 1, 1, 1};
  CHECK(textured_pixels(image) == 2);
}

TEST_CASE("an image's memory is its samples, marks and table", "[categories][image]") {
  CategoryImage image = small({0, 1, 2, 3, 4, 5});
  image.samples.shrink_to_fit();
  const std::size_t without = image.bytes();
  CHECK(without == 6 * sizeof(CategoryId) + image.table.bytes());
  image.textured.assign(6, 0);
  CHECK(image.bytes() == without + image.textured.capacity());
}

}  // namespace
}  // namespace raycat
