#include "render/coverage.hpp"

#include <catch2/catch.hpp>

namespace raycat {
namespace {

TEST_CASE("coverage is by categories, the largest first, and sums to one", "[render][coverage]") {
  // Trees of one node each, of faces 0 to 3; faces 0 and 1 are of one object, 2 and 3 of another.
  SurfaceTable surfaces;
  surfaces.add_object("a");
  surfaces.add_primitive("a", 2);
  surfaces.add_object("b");
  surfaces.add_primitive("b", 2);
  std::vector<RayTree> trees;
  for (std::uint32_t face = 0; face < 4; ++face) {
    trees.push_back({RayNode{.surface = SurfaceId{face}}});
  }
  trees.emplace_back();  // the background
  const auto tree_of = [&](TreeId id) -> const RayTree& {
    return trees[static_cast<std::size_t>(id)];
  };
  const auto share = [](std::uint32_t tree, float of) {
    return TreeShare{.tree = TreeId{tree}, .share = of};
  };
  AntialiasedPicture picture(2, 1);
  picture.coverage = {{share(4, 0.25f), share(0, 0.25f), share(2, 0.125f), share(0, 0.375f)},
                      {share(3, 0.5f), share(1, 0.25f), share(0, 0.25f)}};

  const CoverageImage faces = coverage_image(picture, tree_of, surfaces, {}, 3);
  CHECK(faces.ids == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 1});
  CHECK(faces.shares == std::vector<float>{0.625f, 0.25f, 0.125f, 0.5f, 0.25f, 0.25f});
  CHECK(faces.categories == 5);

  Detail objects;
  objects.ids = Granularity::object;
  const CoverageImage two = coverage_image(picture, tree_of, surfaces, objects, 2);
  CHECK(two.ids == std::vector<std::uint32_t>{1, 2, 3, 1});
  CHECK(two.shares[0] == Approx(0.625 / 0.875));
  CHECK(two.shares[1] == Approx(0.25 / 0.875));
  CHECK(two.shares[2] == 0.5f);
  CHECK(two.shares[3] == 0.5f);
}

}  // namespace
}  // namespace raycat
