#include "render/view_as.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "render/paint.hpp"
#include "tracer/srgb.hpp"

namespace raycat {
namespace {

// What a view shows of one tree.
struct Measure {
  int depth = 0;
  int nodes = 0;
  int lights = 0;
  int reflected_nodes = 0;
  int refracted_nodes = 0;
};

Measure measure(const RayTree& tree) {
  Measure result{.nodes = static_cast<int>(tree.size())};
  for (const RayNode& node : tree) {
    const int deep = level(node.position);
    result.depth = std::max(result.depth, deep);
    if (node.position == root) {
      result.lights = std::popcount(node.lights);
      continue;
    }
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): only the root has level 1
    const HeapPosition child_of_root = node.position >> (deep - 2);
    ++(child_of_root == reflected(root) ? result.reflected_nodes : result.refracted_nodes);
  }
  return result;
}

// Linear, from sRGB bytes.
glm::vec3 colour(int r, int g, int b) {
  return {linear_from_srgb(static_cast<float>(r) / 255.0f),
          linear_from_srgb(static_cast<float>(g) / 255.0f),
          linear_from_srgb(static_cast<float>(b) / 255.0f)};
}

// The viridis colour map at `x` from 0 to 1, between nine of its colours; on the 8-bit sRGB grid.
glm::vec3 viridis(float x) {
  static constexpr std::array<std::array<float, 3>, 9> map{{{68, 1, 84},
                                                            {71, 44, 122},
                                                            {59, 81, 139},
                                                            {44, 113, 142},
                                                            {33, 144, 141},
                                                            {39, 173, 129},
                                                            {92, 200, 99},
                                                            {170, 220, 50},
                                                            {253, 231, 37}}};
  const float place = std::clamp(x, 0.0f, 1.0f) * 8.0f;
  const auto below = static_cast<std::size_t>(std::min(place, 7.0f));
  const float part = place - static_cast<float>(below);
  const auto channel = [&](std::size_t c) {
    return static_cast<int>(
        std::lround(map[below][c] + part * (map[below + 1][c] - map[below][c])));
  };
  return colour(channel(0), channel(1), channel(2));
}

const glm::vec3 white(1.0f);
const glm::vec3 grey = colour(160, 160, 160);
const glm::vec3 magenta = colour(204, 121, 167);
const glm::vec3 green = colour(0, 158, 115);
const glm::vec3 yellow = colour(240, 228, 66);

glm::vec3 branch_colour(const Measure& of) {
  if (of.nodes == 0) {
    return white;
  }
  if (of.reflected_nodes == of.refracted_nodes) {
    return of.reflected_nodes == 0 ? grey : yellow;
  }
  return of.reflected_nodes > of.refracted_nodes ? magenta : green;
}

int number(const Measure& of, View view) {
  return view == View::depth ? of.depth : view == View::nodes ? of.nodes : of.lights;
}

}  // namespace

std::string_view name(View view) {
  constexpr std::array<std::string_view, all_views.size()> names{"depth", "nodes", "lights",
                                                                 "branch", "category"};
  return names.at(static_cast<std::size_t>(view));
}

ViewImage view_image(CategoryTrees& trees, View view) {
  const CategoryImage& categories = trees.image();
  if (view == View::category) {
    return {.image = segment_image(categories),
            .legend = "a colour for each category, a hash of it; white: no hit that counts"};
  }
  std::vector<Measure> measures;
  int most = 0;
  for (std::size_t id = 0; id < categories.table.size(); ++id) {
    measures.push_back(measure(trees.tree(CategoryId{static_cast<std::uint32_t>(id)})));
    most = std::max(most, number(measures.back(), view));
  }
  std::vector<glm::vec3> colours;
  for (const Measure& of : measures) {
    if (view == View::branch) {
      colours.push_back(branch_colour(of));
    } else {
      const float part =
          static_cast<float>(number(of, view)) / static_cast<float>(std::max(1, most));
      colours.push_back(of.nodes == 0 ? white : viridis(part));
    }
  }
  if (view == View::branch) {
    return {.image = painted(categories, colours),
            .legend =
                "more nodes by reflection: magenta (204,121,167), by refraction: green "
                "(0,158,115), as many: yellow (240,228,66), the surface alone: grey "
                "(160,160,160); white: no hit that counts"};
  }
  return {.image = painted(categories, colours),
          .legend = fmt::format(
              "{}: viridis from 0 (68,1,84) to {} (253,231,37); white: no hit that counts",
              name(view), most)};
}

}  // namespace raycat
