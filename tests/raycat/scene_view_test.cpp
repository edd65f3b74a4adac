#include <catch2/catch.hpp>

#include "raycat/raycat.hpp"

namespace raycat {
namespace {

const std::string scenes = std::string(RAYCAT_ASSETS) + "/scenes/";

TEST_CASE("a file without camera and lights is framed and lit, and its edges are found",
          "[raycat]") {
  const SceneView view(scenes + "bracket.csg");
  REQUIRE(view.scene().lights.size() == 2);
  CHECK(view.scene().lights[0].name == "headlight");
  CHECK(view.scene().lights[1].name == "key light");
  const Rendering picture = view.render({.width = 90, .height = 70});
  const std::size_t edges = detect_edges(picture.categories).count();
  CHECK(edges > 300);
  CHECK(edges < 3000);
  // Nothing of the part is cut off: its outline does not touch the picture's border.
  for (int x = 0; x < 90; ++x) {
    CHECK(picture.categories.at(x, 0) == picture.categories.at(0, 0));
    CHECK(picture.categories.at(x, 69) == picture.categories.at(0, 0));
  }
}

TEST_CASE("a file's own camera and lights are kept, and another camera may be given", "[raycat]") {
  const SceneFile file = load_scene(scenes + "fig10.gltf");
  REQUIRE_FALSE(file.scene.cameras.empty());
  const SceneView own(file);
  CHECK(own.camera(10, 10).eye == file.scene.cameras.front().eye);
  CHECK(own.scene().lights.size() == file.scene.lights.size());
  const Camera other = look_at({0, 9, 9}, {0, 0, 0}, {0, 1, 0});
  CHECK(SceneView(file, other).camera(10, 10).eye == other.eye);
}

TEST_CASE("a framed scene fits pictures of any shape", "[raycat]") {
  const SceneView view(scenes + "bracket.csg");
  for (const auto& [width, height] : {std::pair(120, 30), std::pair(30, 120)}) {
    const CategoryImage image = view.render({.width = width, .height = height}).categories;
    for (int x = 0; x < width; ++x) {
      CHECK(image.at(x, 0) == image.at(0, 0));
    }
    for (int y = 0; y < height; ++y) {
      CHECK(image.at(0, y) == image.at(0, 0));
    }
  }
}

TEST_CASE("copies of a view share what they hold", "[raycat]") {
  const SceneView view(scenes + "fig10.gltf");
  const SceneView copy = view;
  CHECK(&copy.scene() == &view.scene());
  CHECK(&copy.accel() == &view.accel());
}

TEST_CASE("pictures without pixels, levels or threads are refused", "[raycat]") {
  const SceneView view(scenes + "fig10.gltf");
  CHECK_THROWS_WITH(view.render({.width = 0}), Catch::Contains("0x512 pixels"));
  CHECK_THROWS_AS(view.render({.width = 9, .height = -1}), std::invalid_argument);
  CHECK_THROWS_AS(view.render({.width = 9, .height = 9, .levels = 65}), std::invalid_argument);
  CHECK_THROWS_AS(view.render({.width = 9, .height = 9, .levels = 0}), std::invalid_argument);
  CHECK_THROWS_AS(view.render({.width = 9, .height = 9, .threads = 0}), std::invalid_argument);
}

TEST_CASE("a view of a file that is not there says so", "[raycat]") {
  CHECK_THROWS_WITH(SceneView("nowhere.gltf"), Catch::Contains("nowhere.gltf"));
}

}  // namespace
}  // namespace raycat
