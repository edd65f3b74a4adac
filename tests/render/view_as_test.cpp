#include "render/view_as.hpp"

#include <catch2/catch.hpp>

#include "tracer/srgb.hpp"

namespace raycat {
namespace {

constexpr SurfaceId A{0}, B{1};

// One row of pixels, each with a tree of its own.
CategoryImage row(const std::vector<RayTree>& trees, const Encoder& heap) {
  CategoryImage image{.width = static_cast<int>(trees.size()), .height = 1, .encoder = heap};
  CategoryWords words;
  for (int y = 0; y < 2; ++y) {
    for (std::size_t x = 0; x <= trees.size(); ++x) {
      encode(heap, trees[std::min(x, trees.size() - 1)], words);
      image.samples.push_back(image.table.intern(words));
    }
  }
  return image;
}

const Encoder heap = make_encoder(Method::heap, {.levels = 8, .lights = 3, .surfaces = 2});

// Nothing; a surface in two lights; a mirror that shows one that shows a third; glass whose
// refraction goes on and whose reflection does not; one child each.
const std::vector<RayTree> trees{
    {},
    {{.position = 1, .lights = 0b11, .surface = A}},
    {{.position = 7, .surface = A}, {.position = 3, .surface = B}, {.position = 1, .surface = A}},
    {{.position = 4, .surface = B},
     {.position = 2, .surface = B},
     {.position = 3, .surface = A},
     {.position = 1, .lights = 0b100, .surface = B}},
    {{.position = 2, .surface = A}, {.position = 3, .surface = A}, {.position = 1, .surface = B}}};

ViewImage shown(const Encoder& encoder, View view) {
  const CategoryImage image = row(trees, encoder);
  CategoryTrees of(image);
  return view_image(of, view);
}

glm::ivec3 bytes(const glm::vec3& colour) {
  glm::ivec3 result;
  for (int c = 0; c < 3; ++c) {
    result[c] = static_cast<int>(std::lround(255.0f * srgb_from_linear(colour[c])));
  }
  return result;
}

std::vector<glm::ivec3> shown(View view) {
  std::vector<glm::ivec3> colours;
  for (const glm::vec3& pixel : shown(heap, view).image.pixels) {
    colours.push_back(bytes(pixel));
  }
  return colours;
}

const glm::ivec3 white(255, 255, 255);
const glm::ivec3 zero(68, 1, 84);     // viridis from here
const glm::ivec3 most(253, 231, 37);  // to here
const glm::ivec3 half(33, 144, 141);

TEST_CASE("depth and nodes are coloured from nothing to the most there is", "[render][view]") {
  const auto depth = shown(View::depth);
  CHECK(depth[0] == white);
  CHECK(depth[2] == most);
  CHECK(depth[3] == most);
  CHECK(depth[4] != most);
  const auto nodes = shown(View::nodes);
  CHECK(nodes[0] == white);
  CHECK(nodes[3] == most);
  CHECK(nodes[2] == nodes[4]);
  CHECK(nodes[1] != nodes[2]);
}

TEST_CASE("lights are those that reach the surface seen", "[render][view]") {
  const auto lights = shown(View::lights);
  CHECK(lights[0] == white);
  CHECK(lights[1] == most);
  CHECK(lights[2] == zero);
  CHECK(lights[3] == half);
}

TEST_CASE("the branch is the one with more nodes", "[render][view]") {
  const auto branch = shown(View::branch);
  CHECK(branch[0] == white);
  CHECK(branch[1] == glm::ivec3(160, 160, 160));
  CHECK(branch[2] == glm::ivec3(204, 121, 167));
  CHECK(branch[3] == glm::ivec3(0, 158, 115));
  CHECK(branch[4] == glm::ivec3(240, 228, 66));
}

TEST_CASE("legends say the range, and every view has a name", "[render][view]") {
  CHECK(shown(heap, View::nodes).legend ==
        "nodes: viridis from 0 (68,1,84) to 4 (253,231,37); white: no hit that counts");
  CHECK(name(View::branch) == "branch");
}

TEST_CASE("trees can be seen only in heap categories", "[render][view]") {
  const Encoder string = make_encoder(Method::string, {.levels = 8, .lights = 3, .surfaces = 2});
  CHECK_THROWS_AS(shown(string, View::depth), std::logic_error);
  CHECK_NOTHROW(shown(string, View::category));
}

}  // namespace
}  // namespace raycat
