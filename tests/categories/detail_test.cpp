#include "categories/detail.hpp"

#include <array>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

// Object 0: primitive 0 of faces 0 to 5, primitive 1 of faces 6 and 7. Object 1: face 8.
SurfaceTable surfaces() {
  SurfaceTable table;
  table.add_object("part");
  table.add_primitive("box", 6);
  table.add_primitive("hole", 2);
  table.add_object("ball");
  table.add_primitive("ball", 1);
  return table;
}

const RayTree tree{{.position = 4, .lights = 1, .surface = SurfaceId{8}, .weight = 0.01f},
                   {.position = 2, .lights = 3, .surface = SurfaceId{7}, .weight = 0.1f},
                   {.position = 3, .lights = 2, .surface = SurfaceId{2}, .weight = 0.5f},
                   {.position = 1, .lights = 0, .surface = SurfaceId{6}, .weight = 1.0f}};

RayTree reduced(const Detail& detail) {
  RayTree copy(tree);
  reduce(copy, detail, surfaces());
  return copy;
}

TEST_CASE("full detail keeps the tree as it is", "[categories][detail]") {
  CHECK(reduced({}) == tree);
}

TEST_CASE("levels cut the tree below", "[categories][detail]") {
  CHECK(reduced({.levels = 1}) == RayTree{tree[3]});
  CHECK(reduced({.levels = 2}) == RayTree{tree[1], tree[2], tree[3]});
  CHECK(reduced({.levels = 3}) == tree);
}

TEST_CASE("without lights only surfaces count", "[categories][detail]") {
  for (const RayNode& node : reduced({.lights = false})) {
    CHECK(node.lights == 0);
  }
}

TEST_CASE("surfaces are told apart as finely as asked", "[categories][detail]") {
  const auto ids = [](Granularity granularity) {
    std::vector<SurfaceId> list;
    for (const RayNode& node : reduced({.ids = granularity})) {
      list.push_back(node.surface);
    }
    return list;
  };
  using Ids = std::vector<SurfaceId>;
  CHECK(ids(Granularity::object) == Ids{SurfaceId{1}, SurfaceId{0}, SurfaceId{0}, SurfaceId{0}});
  CHECK(ids(Granularity::primitive) == Ids{SurfaceId{2}, SurfaceId{1}, SurfaceId{0}, SurfaceId{1}});
  CHECK(ids(Granularity::face) == Ids{SurfaceId{8}, SurfaceId{7}, SurfaceId{2}, SurfaceId{6}});
}

TEST_CASE("nodes that count for too little are dropped", "[categories][detail]") {
  CHECK(reduced({.min_weight = 0.01f}) == tree);
  CHECK(reduced({.min_weight = 0.02f}).size() == 3);
  CHECK(reduced({.min_weight = 1.0f}) == RayTree{tree[3]});
}

TEST_CASE("reducing in steps is reducing at once", "[categories][detail]") {
  RayTree steps(tree);
  reduce(steps, {.levels = 2}, surfaces());
  reduce(steps, {.lights = false}, surfaces());
  CHECK(steps == reduced({.levels = 2, .lights = false}));
}

TEST_CASE("a node that a path expression keeps for its lights goes with them",
          "[categories][detail]") {
  const std::array<std::string, 2> lights{"key", "fill"};
  const auto paths = std::make_shared<const PathExpression>("C.*L", surfaces(), lights);
  RayTree lit = reduced({.paths = paths});
  REQUIRE(lit.size() == 3);               // the root has no light
  CHECK(lit[0].surface == SurfaceId{9});  // one past the last, for a surface that is not told
  CHECK(reduced({.lights = false, .paths = paths}).empty());
}

}  // namespace
}  // namespace raycat
