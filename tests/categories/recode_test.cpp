#include "categories/recode.hpp"

#include <algorithm>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "support/paper_trees.hpp"

namespace raycat {
namespace {

const Extent scene{.levels = 8, .lights = 1, .surfaces = 3};

// Three faces, each an object of its own.
SurfaceTable surfaces() {
  SurfaceTable table;
  for (const char* name : {"A", "B", "C"}) {
    table.add_object(name);
    table.add_primitive(name, 1);
  }
  return table;
}

// One pixel with these trees at its corners.
CategoryImage image_of(const std::vector<RayTree>& trees, const Encoder& heap) {
  CategoryImage image{.width = 1, .height = 1, .encoder = heap};
  CategoryWords words;
  for (const RayTree& tree : trees) {
    encode(heap, tree, words);
    image.samples.push_back(image.table.intern(words));
  }
  return image;
}

CategoryImage recoded(const CategoryImage& image, const Detail& detail, const Encoder& to) {
  CategoryTrees trees(image);
  return recode(trees, detail, surfaces(), to);
}

using Ids = std::vector<CategoryId>;
constexpr CategoryId first{0}, second{1}, third{2};

TEST_CASE("an image in its own words is the same image", "[categories][recode]") {
  const Encoder heap = GENERATE(Encoder(PackedHeap(scene)), Encoder(WideHeap(scene)));
  const CategoryImage image =
      image_of({paper::fig4_a, paper::fig2_a, paper::fig2_c, paper::fig4_a}, heap);
  const CategoryImage same = recoded(image, {}, heap);
  CHECK(same.samples == image.samples);
  REQUIRE(same.table.size() == 3);
  for (std::uint32_t id = 0; id < 3; ++id) {
    CHECK(std::ranges::equal(same.table.words(CategoryId{id}), image.table.words(CategoryId{id})));
  }
}

TEST_CASE("trees that a method confuses become one category", "[categories][recode]") {
  const Encoder heap = PackedHeap(scene);
  const CategoryImage image =
      image_of({paper::fig4_a, paper::fig3_a, paper::fig4_b, paper::fig3_b}, heap);
  CHECK(image.samples == Ids{first, second, third, CategoryId{3}});
  const auto by = [&](Method method) {
    return recoded(image, {}, make_encoder(method, scene)).samples;
  };
  CHECK(by(Method::heap) == image.samples);
  CHECK(by(Method::string) == Ids{first, second, first, third});
  CHECK(by(Method::godel) == Ids{first, second, first, third});
  CHECK(by(Method::primes) == Ids{first, second, first, second});
}

TEST_CASE("a lower level of detail joins what it does not tell apart", "[categories][recode]") {
  const Encoder heap = PackedHeap(scene);
  const CategoryImage image =
      image_of({paper::fig4_a, paper::fig4_b, paper::fig2_a, paper::fig2_b}, heap);
  const auto at = [&](const Detail& detail) { return recoded(image, detail, heap); };
  CHECK(at({.levels = 1}).samples == Ids{first, first, second, third});  // C, C, A, AL
  CHECK(at({.levels = 1, .lights = false}).samples == Ids{first, first, second, second});
  CHECK(at({.levels = 1, .lights = false}).table.size() == 2);
}

TEST_CASE("words are made once for each distinct tree", "[categories][recode]") {
  const Encoder heap = PackedHeap(scene);
  const CategoryImage image =
      image_of({paper::fig3_a, paper::fig3_a, paper::fig3_b, paper::fig3_a}, heap);
  std::vector<RayTree> seen;
  CategoryTrees trees(image);
  const CategoryImage sizes = recode(trees, [&](const RayTree& tree, CategoryWords& words) {
    seen.push_back(tree);
    words.assign(1, static_cast<std::uint32_t>(tree.size()));
  });
  CHECK(seen == std::vector<RayTree>{paper::fig3_a, paper::fig3_b});
  CHECK(sizes.samples == Ids{first, first, first, first});
  CHECK(sizes.table.words(first)[0] == 2);
}

TEST_CASE("size and texture marks stay", "[categories][recode]") {
  const Encoder heap = PackedHeap(scene);
  CategoryImage image = image_of({{}, {}, {}, {}}, heap);
  image.textured = {1, 0, 0, 1};
  const CategoryImage same = recoded(image, {}, heap);
  CHECK(same.width == 1);
  CHECK(same.height == 1);
  CHECK(same.textured == image.textured);
}

TEST_CASE("what is not by the heap method cannot be recoded", "[categories][recode]") {
  const Encoder string = make_encoder(Method::string, scene);
  const CategoryImage image = image_of({{}, {}, {}, {}}, string);
  CHECK_THROWS_AS(recoded(image, {}, string), std::logic_error);
}

}  // namespace
}  // namespace raycat
