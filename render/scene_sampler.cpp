#include "render/scene_sampler.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "render/textured_primitives.hpp"
#include "render/thin_things.hpp"
#include "render/tree_difference.hpp"

namespace raycat {

SceneSampler::SceneSampler(const Accel& accel, const Camera& camera, int width, int height,
                           int levels, int threads, Backdrop backdrop, bool keeps)
    : accel_(accel),
      camera_(camera),
      width_(width),
      height_(height),
      plane_(camera, width, height),
      levels_(levels),
      backdrop_(backdrop),
      textured_(textured_primitives(accel.scene())),
      workers_(static_cast<std::size_t>(threads)),
      kept_(keeps ? (static_cast<std::size_t>(width) + 1) * (static_cast<std::size_t>(height) + 1)
                  : 0) {}

SceneSampler::Met SceneSampler::meet(const RayTree& tree) {
  const SurfaceTable& surfaces = accel_.scene().surfaces;
  return {.tree = trees_.intern(tree),
          .textured =
              !textured_.empty() &&
              std::ranges::any_of(
                  tree,
                  [&](const RayNode& node) {
                    return textured_[static_cast<std::size_t>(surfaces.primitive(node.surface))];
                  }),
          .background = tree.empty()};
}

ColourSample SceneSampler::sample_of(const glm::vec3& colour, const Met& met) const {
  const bool left_out = backdrop_ == Backdrop::transparent && met.background;
  return {.colour = left_out ? glm::vec4(0.0f) : glm::vec4(glm::clamp(colour, 0.0f, 1.0f), 1.0f),
          .tree = met.tree,
          .textured = met.textured};
}

void SceneSampler::keep(std::size_t place, const glm::vec3& colour, const RayTree& tree,
                        bool repeats, int worker) {
  std::optional<Met>& met = workers_[static_cast<std::size_t>(worker)].kept;
  if (!met || !repeats) {
    met = meet(tree);
  }
  kept_[place] = sample_of(colour, *met);
}

const ColourSample* SceneSampler::kept_at(const glm::dvec2& point) const {
  if (kept_.empty()) {
    return nullptr;
  }
  const double x = point.x - ImagePlane::to_centre;
  const double y = point.y - ImagePlane::to_centre;
  const bool on_lattice = x == std::floor(x) && y == std::floor(y) && x >= 0.0 && y >= 0.0 &&
                          x <= width_ && y <= height_;
  return on_lattice ? &kept_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) +
                             static_cast<std::size_t>(x)]
                    : nullptr;
}

ColourSample SceneSampler::sample(const glm::dvec2& point, int worker) {
  if (const ColourSample* kept = kept_at(point)) {
    return *kept;
  }
  Worker& at = workers_[static_cast<std::size_t>(worker)];
  at.recorder.start();
  const glm::vec3 colour =
      trace(accel_, plane_.ray(point.x, point.y), levels_, at.recorder, at.scratch);
  if (!at.recorder.repeats() || !at.met) {
    at.met = meet(at.recorder.tree());
  }
  return sample_of(colour, *at.met);
}

// By at most a quarter of the rays of a whole tree: what tells less about a point than its colour
// must cost much less.
bool SceneSampler::tells_cheaply(TreeId a, TreeId b) {
  const RayTree& tree = trees_.tree(a);
  const auto apart = tree_difference(tree, trees_.tree(b));
  if (!apart) {
    return false;
  }
  const std::size_t cheap =
      static_cast<std::size_t>(level(apart->position)) + (apart->light ? 1 : 0);
  const std::size_t whole =
      std::max<std::size_t>(tree.size(), 1) * (1 + accel_.scene().lights.size());
  return 4 * cheap <= whole;
}

std::optional<TreeId> SceneSampler::side(const glm::dvec2& point, TreeId a, TreeId b, int worker) {
  Worker& at = workers_[static_cast<std::size_t>(worker)];
  const RayTree& tree = trees_.tree(a);
  const auto apart = tree_difference(tree, trees_.tree(b));
  if (!apart) {
    const TreeId met = sample(point, worker).tree;
    return met == a || met == b ? std::optional(met) : std::nullopt;
  }
  const auto answer = [&](bool is_a) { return is_a ? a : b; };
  ++at.scratch.rays.camera;
  ChildRay ray{plane_.ray(point.x, point.y), {}};
  Media media;
  // Down to the node that tells them apart, along nodes that both have.
  for (int below = level(apart->position) - 1;; --below) {
    const HeapPosition position = apart->position >> below;
    const std::optional<Hit> hit = accel_.closest(ray, at.scratch.solid, ray.from);
    if (below == 0) {
      if (!apart->light) {
        const auto met = hit ? std::optional(hit->surface) : std::nullopt;
        return met == apart->a   ? std::optional(a)
               : met == apart->b ? std::optional(b)
                                 : std::nullopt;
      }
      if (!hit || hit->surface != apart->a) {
        return std::nullopt;
      }
      const auto light = static_cast<std::size_t>(*apart->light);
      return answer(reaches(accel_, ray, *hit, light, at.scratch) == apart->lit_in_a);
    }
    const RayNode* node = node_at(tree, position);
    if (!hit || node == nullptr || hit->surface != node->surface) {
      return std::nullopt;
    }
    const Shading shading = spawn(accel_, ray, *hit, media, at.scratch);
    const bool by_reflection = (apart->position >> (below - 1) & 1) != 0;
    const std::optional<ChildRay>& next = by_reflection ? shading.reflection : shading.refraction;
    if (!next) {
      return below == 1 && !apart->a   ? std::optional(a)
             : below == 1 && !apart->b ? std::optional(b)
                                       : std::nullopt;
    }
    if (!by_reflection) {
      media = shading.media;
    }
    ++(by_reflection ? at.scratch.rays.reflection : at.scratch.rays.refraction);
    ray = *next;
  }
}

void SceneSampler::thin(const std::function<void(const glm::dvec2&)>& visit) const {
  for_thin_things(accel_.scene(), camera_, width_, height_, visit);
}

RayCounts SceneSampler::rays() const {
  RayCounts sum;
  for (const Worker& worker : workers_) {
    sum += worker.scratch.rays;
  }
  return sum;
}

}  // namespace raycat
