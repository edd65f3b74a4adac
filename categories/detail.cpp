#include "categories/detail.hpp"

namespace raycat {

void reduce(RayTree& tree, const Detail& detail, const SurfaceTable& surfaces) {
  std::erase_if(tree, [&](const RayNode& node) {
    return level(node.position) > detail.levels || node.weight < detail.min_weight;
  });
  if (!detail.lights) {
    for (RayNode& node : tree) {
      node.lights = 0;
    }
  }
  // After the lights, so that nothing stays for a light that does not count.
  if (detail.paths) {
    detail.paths->filter(tree, surfaces);
  }
  if (detail.ids != Granularity::face || detail.paths) {
    const SurfaceId none{static_cast<std::uint32_t>(surfaces.count(detail.ids))};
    for (RayNode& node : tree) {
      node.surface = node.surface == untold ? none : surfaces.at(detail.ids, node.surface);
    }
  }
}

}  // namespace raycat
