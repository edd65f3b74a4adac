#include "edges/comparison.hpp"

#include <array>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// An image of 2 x 1 pixels with these categories on its lattice of 3 x 2 samples.
CategoryImage image(const std::array<std::uint32_t, 6>& samples) {
  CategoryImage result{.width = 2, .height = 1, .samples = {}, .table = {}};
  for (const std::uint32_t word : samples) {
    result.samples.push_back(result.table.intern({&word, 1}));
  }
  return result;
}

TEST_CASE("a method is compared pair by pair and pixel by pixel", "[edges][comparison]") {
  // The first pixel differs from all three neighbours, the second from the one below it.
  const CategoryImage heap = image({1, 2, 2,  //
                                    3, 4, 2});
  const Comparison itself = compare(heap, heap);
  CHECK(itself.edge_pixels == 2);
  CHECK(itself.missed == 0);
  CHECK(itself.false_equalities == 0);
  CHECK(itself.distinct == 4);

  // Does not tell 1 from 3, which the first pixel survives, nor 2 from 4, which the second does
  // not.
  const Comparison coarse = compare(image({1, 2, 2,  //
                                           1, 2, 2}),
                                    heap);
  CHECK(coarse.edge_pixels == 1);
  CHECK(coarse.missed == 1);
  CHECK(coarse.false_equalities == 2);
  CHECK(coarse.distinct == 2);

  const Comparison blind = compare(image({9, 9, 9, 9, 9, 9}), heap);
  CHECK(blind.edge_pixels == 0);
  CHECK(blind.missed == 2);
  CHECK(blind.false_equalities == 4);
}

}  // namespace
}  // namespace raycat
