#include "categories/id_string.hpp"

#include <map>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "support/paper_trees.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

CategoryWords string_of(const RayTree& tree, const Extent& scene) {
  CategoryWords words{99};
  IdString(scene).encode(tree, words);
  return words;
}

// As the paper prints it.
std::string letters(const RayTree& tree) {
  std::string text;
  for (const std::uint32_t symbol : string_of(tree, {.levels = 8, .lights = 1, .surfaces = 3})) {
    text += std::string(" LABC")[symbol];
  }
  return text;
}

// A second way to the symbols: each node's, looked up by its place, depth first.
CategoryWords depth_first(const std::map<HeapPosition, RayNode>& nodes, HeapPosition position,
                          const Extent& scene) {
  const auto found = nodes.find(position);
  if (found == nodes.end()) {
    return {};
  }
  CategoryWords words = depth_first(nodes, 2 * position, scene);
  const CategoryWords reflection = depth_first(nodes, 2 * position + 1, scene);
  words.insert(words.end(), reflection.begin(), reflection.end());
  words.push_back(static_cast<std::uint32_t>(found->second.surface) + 1 +
                  static_cast<std::uint32_t>(scene.lights));
  for (std::uint32_t light = 0; light < scene.lights; ++light) {
    if ((found->second.lights >> light & 1) != 0) {
      words.push_back(light + 1);
    }
  }
  return words;
}

TEST_CASE("the strings of Fig. 2 are ALALA, BLAL and the empty one", "[categories][string]") {
  CHECK(letters(paper::fig2_a) == "ALALA");
  CHECK(letters(paper::fig2_b) == "BLAL");
  CHECK(letters(paper::fig2_c).empty());
}

TEST_CASE("the strings of Fig. 3 are BA and AB", "[categories][string]") {
  CHECK(letters(paper::fig3_a) == "BA");
  CHECK(letters(paper::fig3_b) == "AB");
}

TEST_CASE("the two trees of Fig. 4 have the string ABLC", "[categories][string]") {
  CHECK(letters(paper::fig4_a) == "ABLC");
  CHECK(letters(paper::fig4_b) == "ABLC");
}

TEST_CASE("lights have the lowest symbols, from 1, and follow their node", "[categories][string]") {
  const RayTree tree{{.lights = 0b101, .surface = SurfaceId{0}}};
  CHECK(string_of(tree, {.levels = 1, .lights = 3, .surfaces = 1}) == CategoryWords{4, 1, 3});
  CHECK(string_of({{.surface = SurfaceId{0}}}, {.levels = 1, .surfaces = 1}) == CategoryWords{1});
}

TEST_CASE("symbols stay apart up to the limits", "[categories][string]") {
  const RayTree tree{{.lights = LightMask{1} << 63, .surface = SurfaceId{0}},
                     {.surface = SurfaceId{0xffffffff - 65}}};
  CHECK(string_of(tree, IdString::limits) == CategoryWords{65, 64, 0xffffffff});
  CHECK_THROWS_WITH(IdString({.levels = 8, .lights = 2, .surfaces = 0xffffffff - 63}),
                    "string categories hold at most 4294967231 surfaces, but 4294967232 are "
                    "needed");
}

TEST_CASE("the string of a tree is its symbols depth first", "[categories][string]") {
  CHECK(rc::check([] {
    const Extent scene{.levels = 7, .lights = 3, .surfaces = 5};
    const RayTree tree = draw_tree({.levels = 7, .surfaces = 5, .lights = 3});
    std::map<HeapPosition, RayNode> nodes;
    for (const RayNode& node : tree) {
      nodes[node.position] = node;
    }
    RC_ASSERT((string_of(tree, scene) == depth_first(nodes, root, scene)));
  }));
}

TEST_CASE("all small trees without refraction have strings of their own", "[categories][string]") {
  std::set<CategoryWords> strings;
  const auto trees = all_trees({.levels = 6, .surfaces = 2, .lights = 1, .refraction = false});
  CHECK(trees.size() == 5461);  // 1 + 4 + ... + 4^6
  for (const RayTree& tree : trees) {
    strings.insert(string_of(tree, {.levels = 6, .lights = 1, .surfaces = 2}));
  }
  CHECK(strings.size() == 5461);
}

TEST_CASE("with refraction not all small trees have strings of their own", "[categories][string]") {
  // Of two levels with one surface and no light: none, A, AA twice, AAA.
  std::map<CategoryWords, int> trees;
  for (const RayTree& tree : all_trees({.levels = 2, .surfaces = 1, .lights = 0})) {
    ++trees[string_of(tree, {.levels = 2, .surfaces = 1})];
  }
  CHECK(trees == std::map<CategoryWords, int>{{{}, 1}, {{1}, 1}, {{1, 1}, 2}, {{1, 1, 1}, 1}});
}

TEST_CASE("without refraction two trees are equal when their strings are", "[categories][string]") {
  CHECK(rc::check([] {
    const Extent scene{.levels = 8, .lights = 2, .surfaces = 2};
    const auto [a, b] = draw_pair({.levels = 8, .surfaces = 2, .lights = 2, .refraction = false});
    RC_CLASSIFY(a == b);
    RC_ASSERT((string_of(a, scene) == string_of(b, scene)) == (a == b));
  }));
}

}  // namespace
}  // namespace raycat
