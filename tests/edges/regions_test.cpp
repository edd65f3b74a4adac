#include "edges/regions.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

// Categories drawn as letters, one for each pixel. The lattice's last row and column are of a
// category of their own, which no pixel has.
CategoryImage drawn(const std::vector<std::string>& rows) {
  CategoryImage image{.width = static_cast<int>(rows.empty() ? 0 : rows[0].size()),
                      .height = static_cast<int>(rows.size())};
  const auto add = [&](char c) {
    const auto word = static_cast<std::uint32_t>(c);
    image.samples.push_back(image.table.intern(std::span(&word, 1)));
  };
  for (const std::string& row : rows) {
    std::ranges::for_each(row, add);
    add('$');
  }
  for (int x = 0; x <= image.width; ++x) {
    add('$');
  }
  return image;
}

std::vector<std::uint32_t> numbers(const Regions& regions) {
  std::vector<std::uint32_t> numbers;
  for (const RegionId label : regions.labels) {
    numbers.push_back(static_cast<std::uint32_t>(label));
  }
  return numbers;
}

// As paint spreads, from each pixel that has no region yet.
std::vector<std::uint32_t> flooded(const CategoryImage& image) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * image.width + x); };
  std::vector<std::uint32_t> labels(index(0, image.height), none);
  std::uint32_t next = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (labels[index(x, y)] != none) {
        continue;
      }
      std::vector<std::pair<int, int>> front{{x, y}};
      while (!front.empty()) {
        const auto [px, py] = front.back();
        front.pop_back();
        if (px >= 0 && py >= 0 && px < image.width && py < image.height &&
            labels[index(px, py)] == none && image.at(px, py) == image.at(x, y)) {
          labels[index(px, py)] = next;
          front.insert(front.end(), {{px - 1, py}, {px + 1, py}, {px, py - 1}, {px, py + 1}});
        }
      }
      ++next;
    }
  }
  return labels;
}

TEST_CASE("pixels that touch at a corner alone are apart", "[edges][regions]") {
  const Regions regions = connected_regions(drawn({"ab",  //
                                                   "ba"}));
  CHECK(numbers(regions) == std::vector<std::uint32_t>{0, 1,  //
                                                       2, 3});
  CHECK(regions.sizes == std::vector<std::uint64_t>{1, 1, 1, 1});
  CHECK(regions.categories ==
        std::vector{CategoryId{0}, CategoryId{1}, CategoryId{1}, CategoryId{0}});
}

TEST_CASE("arms that meet further down are one region from the start", "[edges][regions]") {
  const Regions regions = connected_regions(drawn({"a.a.a",  //
                                                   "a.a.a",  //
                                                   "aaa.a",  //
                                                   "....a",  //
                                                   "aaaaa"}));
  CHECK(numbers(regions) == std::vector<std::uint32_t>{0, 1, 0, 2, 3,  //
                                                       0, 1, 0, 2, 3,  //
                                                       0, 0, 0, 2, 3,  //
                                                       2, 2, 2, 2, 3,  //
                                                       3, 3, 3, 3, 3});
  CHECK(regions.sizes == std::vector<std::uint64_t>{7, 2, 7, 9});
  CHECK(regions.at(4, 0) == RegionId{3});
}

TEST_CASE("a spiral and its gap are two regions", "[edges][regions]") {
  const Regions regions = connected_regions(drawn({"#######",  //
                                                   "......#",  //
                                                   "#####.#",  //
                                                   "#...#.#",  //
                                                   "#.###.#",  //
                                                   "#.....#",  //
                                                   "#######"}));
  CHECK(regions.count() == 2);
  CHECK(regions.sizes == std::vector<std::uint64_t>{31, 18});
}

TEST_CASE("an image of one category is one region, and of no pixels none", "[edges][regions]") {
  const Regions one = connected_regions(drawn({"aaaa", "aaaa", "aaaa"}));
  CHECK(one.sizes == std::vector<std::uint64_t>{12});
  CHECK(connected_regions(drawn({})).count() == 0);
}

TEST_CASE("regions are what paint would flood, and each is of one category", "[edges][regions]") {
  CHECK(rc::check("random images", [] {
    const auto width = *rc::gen::inRange<std::size_t>(1, 13);
    const auto height = *rc::gen::inRange<std::size_t>(1, 13);
    const char last = *rc::gen::inRange('a', 'd');
    std::vector<std::string> rows;
    for (std::size_t y = 0; y < height; ++y) {
      rows.push_back(*rc::gen::container<std::string>(
          width, rc::gen::inRange('a', static_cast<char>(last + 1))));
    }
    const CategoryImage image = drawn(rows);
    const Regions regions = connected_regions(image);
    RC_ASSERT(numbers(regions) == flooded(image));

    std::vector<std::uint64_t> sizes(regions.count());
    std::set<CategoryId> seen;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto region = static_cast<std::size_t>(regions.at(x, y));
        ++sizes[region];
        seen.insert(image.at(x, y));
        RC_ASSERT(regions.categories[region] == image.at(x, y));
      }
    }
    RC_ASSERT(regions.sizes == sizes);
    RC_ASSERT(regions.count() >= seen.size());
  }));
}

TEST_CASE("a million pixels in one winding region need no recursion", "[edges][regions]") {
  // A comb's teeth, joined in turn at the top and at the bottom.
  std::vector<std::string> rows(1000, std::string(1000, '#'));
  for (std::size_t x = 1; x < 1000; x += 2) {
    for (std::size_t y = 0; y < 999; ++y) {
      rows[x % 4 == 1 ? y : 999 - y][x] = '.';
    }
  }
  const Regions regions = connected_regions(drawn(rows));
  CHECK(regions.count() == 501);
  CHECK(regions.sizes[0] == 500 * 1000 + 500);
}

}  // namespace
}  // namespace raycat
