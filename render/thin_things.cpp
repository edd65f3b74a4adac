#include "render/thin_things.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "geometry/line_clip.hpp"

namespace raycat {
namespace {

class Finder {
 public:
  using Visit = std::function<void(const glm::dvec2&)>;

  Finder(const Camera& camera, int width, int height, const Visit& visit)
      : camera_(camera),
        visit_(visit),
        plane_(camera, width, height),
        picture_{.min = {0.0, 0.0, -1.0}, .max = {width, height, 1.0}} {}

  void add(const Bounds& local, const Affine& transform) {
    if (local.empty() || !local.finite()) {
      return;
    }
    Seen seen;
    for (std::size_t corner = 0; corner < seen.size(); ++corner) {
      const glm::dvec3 point = transform.point({(corner & 1) != 0 ? local.max.x : local.min.x,
                                                (corner & 2) != 0 ? local.max.y : local.min.y,
                                                (corner & 4) != 0 ? local.max.z : local.min.z});
      const bool before =
          camera_.orthographic || glm::dot(point - camera_.eye, camera_.forward) > 0.0;
      seen[corner] = plane_.project(point);
      if (!before || !std::isfinite(seen[corner].x) || !std::isfinite(seen[corner].y)) {
        return;
      }
    }
    const std::array<glm::dvec2, 2> ends = ends_of(seen);
    const double length = glm::distance(ends[0], ends[1]);
    const glm::dvec2 along = length > 0.0 ? (ends[1] - ends[0]) / length : glm::dvec2(1.0, 0.0);
    double least = 0.0;
    double most = 0.0;
    for (const glm::dvec2& corner : seen) {
      const glm::dvec2 from = corner - ends[0];
      const double across = along.x * from.y - along.y * from.x;
      least = std::min(least, across);
      most = std::max(most, across);
    }
    if (most - least < thin) {
      add_line(ends[0], ends[1]);
    }
  }

 private:
  // Something round that is larger than a pixel's diagonal meets a corner.
  static constexpr double thin = 1.5;

  using Seen = std::array<glm::dvec2, 8>;  // a box's corners, by bits which side of each axis

  // The middles of two opposite sides, which are farthest apart of all.
  static std::array<glm::dvec2, 2> ends_of(const Seen& seen) {
    std::array<glm::dvec2, 2> best{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<glm::dvec2, 2> ends{};
      for (std::size_t corner = 0; corner < seen.size(); ++corner) {
        ends[corner >> axis & 1] += 0.25 * seen[corner];
      }
      if (axis == 0 || glm::distance(ends[0], ends[1]) > glm::distance(best[0], best[1])) {
        best = ends;
      }
    }
    return best;
  }

  void add_line(const glm::dvec2& start, const glm::dvec2& end) {
    const glm::dvec2 way = end - start;
    const Interval inside =
        LineClip({.origin = {start, 0.0}, .direction = {way, 0.0}})(picture_, {0.0, 1.0});
    if (inside.empty()) {
      return;
    }
    constexpr double a_pixel = 4.0;
    const double length = (inside.end - inside.begin) * glm::length(way);
    const double count = length < thin ? 1.0 : std::ceil(a_pixel * length);
    // A double, since counts may be past any integer.
    for (double i = 0.5; i < count; i += 1.0) {
      visit_(start + (inside.begin + i / count * (inside.end - inside.begin)) * way);
    }
  }

  const Camera& camera_;
  const Visit& visit_;
  ImagePlane plane_;
  Bounds picture_;
};

}  // namespace

void for_thin_things(const Scene& scene, const Camera& camera, int width, int height,
                     const std::function<void(const glm::dvec2&)>& visit) {
  Finder finder(camera, width, height, visit);
  for (const SolidObject& object : scene.solids) {
    for (const CsgLeaf& leaf : object.solid.tree().leaves()) {
      finder.add(bounds(leaf.shape.shape()), leaf.shape.transform());
    }
  }
  std::unordered_map<const SurfaceMesh*, Bounds> boxes;
  for (const MeshInstance& instance : scene.meshes) {
    const auto [box, fresh] = boxes.try_emplace(instance.mesh.get());
    if (fresh) {
      box->second = bounds(instance.mesh->triangles);
    }
    finder.add(box->second, instance.transform);
  }
}

}  // namespace raycat
