#include "categories/encoder.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("the packed heap is chosen while it fits, the wide one after", "[categories][encoder]") {
  CHECK(std::holds_alternative<PackedHeap>(heap_encoder(PackedHeap::limits)));
  CHECK(std::holds_alternative<WideHeap>(
      heap_encoder({.levels = 9, .lights = 8, .surfaces = 65536})));
  CHECK(std::holds_alternative<WideHeap>(
      heap_encoder({.levels = 8, .lights = 9, .surfaces = 65536})));
  CHECK(std::holds_alternative<WideHeap>(
      heap_encoder({.levels = 8, .lights = 8, .surfaces = 65537})));
  CHECK_THROWS_WITH(heap_encoder({.levels = 65, .lights = 1, .surfaces = 1}),
                    "wide heap categories hold at most 64 levels, but 65 are needed");
}

TEST_CASE("packed and wide tell the same trees apart", "[categories][encoder]") {
  const Extent small{.levels = 8, .lights = 8, .surfaces = 65536};
  const Encoder packed = heap_encoder(small);
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

}  // namespace
}  // namespace raycat
