#include "tracer/light_passage.hpp"

#include <cmath>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace raycat {

const Material& material_of(const Scene& scene, MaterialId id) {
  return scene.materials[static_cast<std::size_t>(id)];
}

bool LightPassage::through(const SolidObject& object, const Scene& scene, Solid::Scratch& scratch) {
  const Solid& solid = object.solid;
  double since = 0.0;  // where the stretch began that `t` ends
  const glm::vec3* inside = nullptr;
  for (auto met = solid.first(ray_, 0.0, t_end_, scratch); met; met = solid.next(scratch)) {
    const Material& material = material_of(scene, object.materials[met->leaf]);
    light_ *= material.transmission;
    if (stopped()) {
      return false;
    }
    if (met->entering) {
      inside = &material.absorption;
      since = met->t;
    } else {
      absorb(inside != nullptr ? *inside : material.absorption, since, met->t);
      inside = nullptr;
    }
  }
  if (inside != nullptr) {
    absorb(*inside, since, t_end_);
  }
  return true;
}

void LightPassage::through(const glm::vec3& transmission, const glm::vec3& absorption,
                           bool entering, double t) {
  light_ *= transmission;
  if (absorption != glm::vec3(0.0f)) {
    cross(absorption, entering, t);
  }
}

bool LightPassage::first_of_passage(unsigned mesh, float t, float near) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (first_[i].first == mesh && std::abs(first_[i].second - t) <= near) {
      return false;
    }
  }
  if (count_ < first_.size()) {
    first_[count_++] = {mesh, t};
    return true;
  }
  if (!others_) {
    others_ = std::make_unique<std::set<Passage>>();
  }
  const auto after = others_->lower_bound({mesh, t});
  const auto is_near = [&](const Passage& other) {
    return other.first == mesh && std::abs(other.second - t) <= near;
  };
  if ((after != others_->end() && is_near(*after)) ||
      (after != others_->begin() && is_near(*std::prev(after)))) {
    return false;
  }
  others_->emplace_hint(after, mesh, t);
  return true;
}

void LightPassage::absorb(const glm::vec3& absorption, double begin, double end) {
  for (int c = 0; c < 3; ++c) {
    if (absorption[c] != 0.0f) {  // or an endless way would make it no number
      depth_[c] += absorption[c] * (end - begin);
    }
  }
}

// A ray that starts inside of a mesh is `open_` by less than nothing, and has the way to its end
// counted.
glm::vec3 LightPassage::left() const {
  if (depth_ == glm::dvec3(0.0) && open_ == glm::dvec3(0.0)) {
    return light_;
  }
  glm::dvec3 depth = depth_;
  for (int c = 0; c < 3; ++c) {
    depth[c] += open_[c] > 0.0 ? open_[c] * t_end_ : 0.0;
  }
  return light_ * glm::vec3(glm::exp(-glm::max(depth, 0.0) * glm::length(ray_.direction)));
}

}  // namespace raycat
