#include "categories/encoder.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "support/paper_trees.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

TEST_CASE("the packed heap is chosen while it fits, the wide one after", "[categories][encoder]") {
  CHECK(std::holds_alternative<PackedHeap>(make_encoder(Method::heap, PackedHeap::limits)));
  CHECK(std::holds_alternative<WideHeap>(
      make_encoder(Method::heap, {.levels = 9, .lights = 8, .surfaces = 65536})));
  CHECK(std::holds_alternative<WideHeap>(
      make_encoder(Method::heap, {.levels = 8, .lights = 9, .surfaces = 65536})));
  CHECK(std::holds_alternative<WideHeap>(
      make_encoder(Method::heap, {.levels = 8, .lights = 8, .surfaces = 65537})));
  CHECK_THROWS_WITH(make_encoder(Method::heap, {.levels = 65, .lights = 1, .surfaces = 1}),
                    "wide heap categories hold at most 64 levels, but 65 are needed");
}

TEST_CASE("packed and wide tell the same trees apart", "[categories][encoder]") {
  const Extent small{.levels = 8, .lights = 8, .surfaces = 65536};
  const Encoder packed = make_encoder(Method::heap, small);
  const Encoder wide = WideHeap(small);
  const std::vector<RayTree> trees{{},
                                   {{.position = 1}},
                                   {{.position = 1, .lights = 1}},
                                   {{.position = 1, .surface = SurfaceId{1}}},
                                   {{.position = 2}, {.position = 1}},
                                   {{.position = 3}, {.position = 1}}};
  for (const RayTree& a : trees) {
    for (const RayTree& b : trees) {
      CategoryWords a_packed, b_packed, a_wide, b_wide;
      encode(packed, a, a_packed);
      encode(packed, b, b_packed);
      encode(wide, a, a_wide);
      encode(wide, b, b_wide);
      CHECK((a_packed == b_packed) == (&a == &b));
      CHECK((a_wide == b_wide) == (&a == &b));
    }
  }
}

TEST_CASE("each method has its encoder and its name", "[categories][encoder]") {
  const Extent scene{.levels = 8, .lights = 2, .surfaces = 10};
  CHECK(std::holds_alternative<IdString>(make_encoder(Method::string, scene)));
  CHECK(std::holds_alternative<PrimesProduct>(make_encoder(Method::primes, scene)));
  CHECK(std::holds_alternative<GodelNumber>(make_encoder(Method::godel, scene)));
  CHECK(name(Method::heap) == "heap");
  CHECK(name(Method::string) == "string");
  CHECK(name(Method::primes) == "primes");
  CHECK(name(Method::godel) == "godel");
}

TEST_CASE("of the paper's trees each method confuses those that the paper says",
          "[categories][encoder]") {
  struct Row {
    const RayTree& a;
    const RayTree& b;
    Method method;
    bool confused;
  };
  const auto row = GENERATE(Row{paper::fig2_a, paper::fig2_b, Method::primes, false},
                            Row{paper::fig3_a, paper::fig3_b, Method::primes, true},
                            Row{paper::fig3_a, paper::fig3_b, Method::string, false},
                            Row{paper::fig3_a, paper::fig3_b, Method::godel, false},
                            Row{paper::fig3_a, paper::fig3_b, Method::heap, false},
                            Row{paper::fig4_a, paper::fig4_b, Method::primes, true},
                            Row{paper::fig4_a, paper::fig4_b, Method::string, true},
                            Row{paper::fig4_a, paper::fig4_b, Method::godel, true},
                            Row{paper::fig4_a, paper::fig4_b, Method::heap, false});
  const Encoder encoder = make_encoder(row.method, {.levels = 8, .lights = 1, .surfaces = 3});
  CategoryWords a, b;
  encode(encoder, row.a, a);
  encode(encoder, row.b, b);
  CAPTURE(name(row.method));
  CHECK((a == b) == row.confused);
}

TEST_CASE("what a method tells apart, each finer method does too", "[categories][encoder]") {
  // Equal trees have equal words, equal strings equal products.
  CHECK(rc::check([] {
    const Extent scene{.levels = 6, .lights = 2, .surfaces = 3};
    const auto [a, b] = draw_pair({});
    const auto same = [&, &a = a, &b = b](Method method) {
      const Encoder encoder = make_encoder(method, scene);
      CategoryWords of_a, of_b;
      encode(encoder, a, of_a);
      encode(encoder, b, of_b);
      return of_a == of_b;
    };
    RC_ASSERT(same(Method::heap) == (a == b));
    RC_ASSERT((!same(Method::heap) || same(Method::string)));
    RC_ASSERT((!same(Method::string) || same(Method::primes)));
    RC_ASSERT(same(Method::godel) == same(Method::string));
  }));
}

TEST_CASE("only the methods that make one number overflow", "[categories][encoder]") {
  RayTree tree;
  for (int i = 20; i > 0; --i) {  // 20 surfaces of symbol 1: prime 2, and exponent 1
    tree.push_back({.position = (HeapPosition{1} << i) - 1});
  }
  const auto over = [&](Method method, std::uint32_t surface) {
    tree.back().surface = SurfaceId{surface};
    const Encoder encoder = make_encoder(method, {.levels = 20, .surfaces = 100});
    CategoryWords words;
    encode(encoder, tree, words);
    return overflowed(encoder, words);
  };
  CHECK_FALSE(over(Method::primes, 0));  // 2^20
  CHECK(over(Method::godel, 0));         // 2 3 5 ... 71
  CHECK_FALSE(over(Method::heap, 99));
  CHECK_FALSE(over(Method::string, 99));
  tree.resize(1);
  CHECK_FALSE(over(Method::godel, 62));  // 2^63
  CHECK(over(Method::godel, 63));        // 2^64
  CHECK_FALSE(over(Method::primes, 99));
}

TEST_CASE("only heap categories are read back", "[categories][encoder]") {
  CHECK(rc::check([] {
    const Extent scene{
        .levels = static_cast<std::uint64_t>(*rc::gen::element(6, 9)), .lights = 2, .surfaces = 3};
    const Encoder encoder = make_encoder(Method::heap, scene);
    const RayTree tree = draw_tree({});
    CategoryWords words;
    RayTree back;
    encode(encoder, tree, words);
    decode(encoder, words, back);
    RC_ASSERT((back == tree));
  }));
  RayTree tree;
  for (const Method method : {Method::string, Method::primes, Method::godel}) {
    CHECK_THROWS_AS(decode(make_encoder(method, {}), CategoryWords{}, tree), std::logic_error);
  }
}

}  // namespace
}  // namespace raycat
