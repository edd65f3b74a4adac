#include "tracer/light_passage.hpp"

#include <cmath>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace raycat {

void LightPassage::through(const glm::vec3& transmission, const glm::vec3& absorption,
                           bool entering, double t) {
  through(transmission);
  if (absorption != glm::vec3(0.0f)) {
    cross(absorption, entering, t);
  }
}

bool LightPassage::first_of_passage(std::size_t mesh, bool entering, double t, double near) {
  const std::size_t side = 2 * mesh + (entering ? 1 : 0);
  for (std::size_t i = 0; i < count_; ++i) {
    if (first_[i].first == side && std::abs(first_[i].second - t) <= near) {
      return false;
    }
  }
  if (count_ < first_.size()) {
    first_[count_++] = {side, t};
    return true;
  }
  if (!others_) {
    others_ = std::make_unique<std::set<Passage>>();
  }
  const auto after = others_->lower_bound({side, t});
  const auto is_near = [&](const Passage& other) {
    return other.first == side && std::abs(other.second - t) <= near;
  };
  if ((after != others_->end() && is_near(*after)) ||
      (after != others_->begin() && is_near(*std::prev(after)))) {
    return false;
  }
  others_->emplace_hint(after, side, t);
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
