#include "raytree/listing.hpp"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "categories/encoder.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

// A random tree with weights, listed the way a recursive tracer does.
RayTree draw_listed() {
  RayTree tree = draw_tree({.levels = 7});
  for (RayNode& node : tree) {
    node.weight = *rc::gen::element(0.25f, 0.5f);
  }
  return tree;
}

bool same_with_weights(const RayTree& a, const RayTree& b) {
  return std::ranges::equal(
      a, b, [](const RayNode& x, const RayNode& y) { return x == y && x.weight == y.weight; });
}

// A permutation of `tree`, by Fisher and Yates.
RayTree shuffled(RayTree tree) {
  for (std::size_t left = tree.size(); left > 1; --left) {
    std::swap(tree[left - 1], tree[*rc::gen::inRange<std::size_t>(0, left)]);
  }
  return tree;
}

TEST_CASE("nodes recorded level by level are listed children first", "[categories][listing]") {
  RayTree tree;
  for (const HeapPosition position : {1u, 2u, 3u, 4u, 5u, 7u, 10u, 14u}) {
    tree.push_back({.position = position});
  }
  sort_as_listed(tree);
  std::vector<HeapPosition> positions;
  for (const RayNode& node : tree) {
    positions.push_back(node.position);
  }
  CHECK(positions == std::vector<HeapPosition>{4, 10, 5, 2, 14, 7, 3, 1});
}

TEST_CASE("positions of level 64 are listed too", "[categories][listing]") {
  const HeapPosition deepest = HeapPosition{1} << 63;
  CHECK(listed_before(deepest, root));
  CHECK(listed_before(deepest, deepest + 1));
  CHECK(listed_before(deepest + 1, deepest >> 1));
  CHECK_FALSE(listed_before(root, deepest));
  CHECK_FALSE(listed_before(root, root));
}

TEST_CASE("a tree recorded in any order is sorted to the list of the recursion",
          "[categories][listing]") {
  CHECK(rc::check([] {
    const RayTree listed = draw_listed();
    RayTree tree = shuffled(listed);
    sort_as_listed(tree);
    RC_ASSERT(same_with_weights(tree, listed));
  }));
}

TEST_CASE("every method encodes a sorted tree as the recursion's", "[categories][listing]") {
  CHECK(rc::check([] {
    const RayTree listed = draw_listed();
    RayTree tree = shuffled(listed);
    sort_as_listed(tree);
    for (const Method method : {Method::heap, Method::string, Method::primes, Method::godel}) {
      const Encoder encoder = make_encoder(method, {.levels = 7, .lights = 2, .surfaces = 3});
      CategoryWords words, of_listed;
      encode(encoder, tree, words);
      encode(encoder, listed, of_listed);
      RC_ASSERT((words == of_listed));
    }
  }));
}

TEST_CASE("a tree that is listed already stays, and so does the empty one",
          "[categories][listing]") {
  RayTree empty;
  sort_as_listed(empty);
  CHECK(empty.empty());
  CHECK(rc::check([] {
    const RayTree listed = draw_listed();
    RayTree tree = listed;
    sort_as_listed(tree);
    RC_ASSERT(same_with_weights(tree, listed));
  }));
}

}  // namespace
}  // namespace raycat
