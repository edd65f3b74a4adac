#include "reference/agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "edges/edge_map.hpp"

namespace raycat::reference {
namespace {

// The line of sight through the centre of pixel (x, y), and between them.
Line line_of_sight(const Camera& camera, int width, int height, Real x, Real y) {
  const Real pixel = 2.0L * camera.half_height / height;
  const Vec across = (x + 0.5L - width / 2.0L) * pixel * Vec(camera.right) +
                     (height / 2.0L - y - 0.5L) * pixel * Vec(camera.up);
  if (camera.orthographic) {
    return {.origin = Vec(camera.eye) + across, .direction = glm::normalize(Vec(camera.forward))};
  }
  return {.origin = Vec(camera.eye), .direction = glm::normalize(Vec(camera.forward) + across)};
}

std::string text(const Scene& scene, const RayTree& tree) {
  std::string result;
  for (const RayNode& node : tree) {
    result += fmt::format(" {}:{}#{}/{:b}", node.position,
                          scene.surfaces.name(scene.surfaces.object(node.surface)),
                          static_cast<std::uint32_t>(node.surface), node.lights);
  }
  return result.empty() ? " nothing" : result;
}

}  // namespace

Agreement compare_with_reference(const Scene& scene, const Camera& camera,
                                 const RenderSettings& settings, Rules rules) {
  const Accel accel(scene);
  const Rendering ours = render(accel, camera, settings);
  const CategoryImage& image = ours.categories;
  const EdgeMap edges = detect_edges(image);
  const Surroundings around(scene);
  rules.levels = settings.levels;
  const Tracing tracing(around, rules);
  const int width = settings.width;
  const int height = settings.height;
  const auto sample = [&](Real x, Real y) {
    return tracing(line_of_sight(camera, width, height, x, y));
  };
  const auto on_a_border = [&](int x, int y, const RayTree& tree) {
    const Real hair = 1e-9L * width;
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0),
                                 std::pair(0, -1), std::pair(1, 1), std::pair(-1, -1)}) {
      if (sample(x + dx * hair, y + dy * hair).tree != tree) {
        return true;
      }
    }
    return false;
  };

  Agreement result;
  const auto note = [&](int& count, const std::string& what) {
    ++count;
    if (result.first.empty()) {
      result.first = what;
    }
  };
  std::vector<RayTree> trees;
  std::vector<bool> excused;
  for (int y = 0; y <= height; ++y) {
    for (int x = 0; x <= width; ++x) {
      const Traced traced = sample(x, y);
      ++result.samples;
      trees.push_back(traced.tree);
      excused.push_back(false);
      RayTree tree;
      decode(*image.encoder, image.table.words(image.at(x, y)), tree);
      if (tree != traced.tree) {
        if (on_a_border(x, y, traced.tree)) {
          ++result.excused;
          excused.back() = true;
        } else {
          note(result.trees, fmt::format("sample {}, {} is{}\nand by the reference{}", x, y,
                                         text(scene, tree), text(scene, traced.tree)));
        }
      } else if (x < width && y < height) {
        const Vec colour(ours.colour.pixels[ours.colour.index(x, y)]);
        for (int c = 0; c < 3; ++c) {
          if (std::abs(colour[c] - traced.colour[c]) > 1e-4L * std::max(1.0L, traced.colour[c])) {
            note(result.colours,
                 fmt::format("pixel {}, {} is {} and by the reference {} in channel {}:{}", x, y,
                             static_cast<double>(colour[c]), static_cast<double>(traced.colour[c]),
                             c, text(scene, tree)));
            break;
          }
        }
      }
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::array corners{image.index(x, y), image.index(x + 1, y), image.index(x, y + 1),
                               image.index(x + 1, y + 1)};
      const bool excuse = std::ranges::any_of(corners, [&](std::size_t i) { return excused[i]; });
      const bool edge = std::ranges::any_of(
          corners, [&](std::size_t i) { return trees[i] != trees[corners[0]]; });
      if (!excuse && edge != edges.at(x, y)) {
        note(result.edges, fmt::format("pixel {}, {} is {}an edge", x, y, edge ? "not " : ""));
      }
    }
  }
  return result;
}

}  // namespace raycat::reference
