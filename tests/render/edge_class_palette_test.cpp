#include "render/edge_class_palette.hpp"

#include <set>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

using Srgb = std::array<std::uint8_t, 3>;

TEST_CASE("each class has its colour and no class is white", "[render][palette]") {
  const auto palette = edge_class_palette();
  CHECK(palette[0] == Srgb{255, 255, 255});
  CHECK(palette[1] == Srgb{30, 30, 30});
  CHECK(palette[2] == Srgb{0, 114, 178});
  CHECK(palette[4] == Srgb{86, 180, 233});
  CHECK(palette[8] == Srgb{230, 159, 0});
  CHECK(palette[16] == Srgb{204, 121, 167});
  CHECK(palette[32] == Srgb{0, 158, 115});
}

TEST_CASE("several classes have the mean of their colours, halves rounded up",
          "[render][palette]") {
  const auto palette = edge_class_palette();
  CHECK(palette[8 | 16] == Srgb{217, 140, 84});       // 217, 140, 83.5
  CHECK(palette[1 | 32] == Srgb{15, 94, 73});         // 15, 94, 72.5
  CHECK(palette[4 | 16 | 32] == Srgb{97, 153, 172});  // 96.7, 153, 171.7
}

TEST_CASE("no two masks have one colour", "[render][palette]") {
  const auto palette = edge_class_palette();
  CHECK(std::set(palette.begin(), palette.end()).size() == 64);
}

TEST_CASE("the legend says which bit is which class", "[render][palette]") {
  CHECK(edge_class_legend() ==
        "1 object, 2 primitive, 4 face, 8 shadow, 16 reflection, 32 refraction");
}

}  // namespace
}  // namespace raycat
