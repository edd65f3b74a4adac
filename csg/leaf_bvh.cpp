#include "csg/leaf_bvh.hpp"

#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace raycat {
namespace {

constexpr float float_ulp = 0x1p-23f;

}  // namespace

std::optional<LeafBvh::Line> LeafBvh::line(const Ray& ray, const Interval& window) const {
  if (nodes_.empty()) {
    return std::nullopt;
  }
  const Interval inside = LineClip(ray)(bounds_, window);
  if (inside.empty()) {
    return std::nullopt;
  }
  Line line{};
  line.t_origin = std::clamp(0.0, inside.begin, inside.end);
  const glm::dvec3 size = glm::abs(ray.direction);
  const double largest = std::max({size.x, size.y, size.z});
  line.per_t = largest / scale_;
  for (int axis = 0; axis < 3; ++axis) {
    // With a fused multiplication the point is on the line to its last bit, wherever that begins.
    const double start = std::fma(line.t_origin, ray.direction[axis], ray.origin[axis]);
    // A line that gains less than this on its way through the boxes is as good as parallel.
    constexpr double least = 1e-30;
    const double slope = ray.direction[axis] / largest;
    const auto i = static_cast<std::size_t>(axis);
    line.origin[i] = static_cast<float>((start - center_[axis]) / scale_);
    line.inverse[i] =
        static_cast<float>(1.0 / (std::abs(slope) > least ? slope : std::copysign(least, slope)));
    const bool down = line.inverse[i] < 0.0f;
    line.near[i] = static_cast<std::uint8_t>(down ? 3 + axis : axis);
    line.far[i] = static_cast<std::uint8_t>(down ? axis : 3 + axis);
  }
  // No box is farther than 3 along the line; within that, rounding is less than the margin.
  const auto along = [&](double t) {
    return static_cast<float>(std::clamp((t - line.t_origin) * line.per_t, -4.0, 4.0));
  };
  line.begin = along(window.begin) - 4.0f * float_ulp;
  line.end = along(window.end) + 4.0f * float_ulp;
  return line;
}

void LeafBvh::Search::start(const LeafBvh& index, const Ray& ray, const Interval& window) {
  index_ = &index;
  steps_.clear();
  for (const std::uint32_t box : index.unbounded_) {
    steps_.push_back({.t = -std::numeric_limits<float>::infinity(), .child = box | box_bit});
  }
  if (const std::optional<Line> line = index.line(ray, window)) {
    line_ = *line;
    steps_.push_back({.t = line_.begin, .child = 0});
  } else {
    line_ = {};
  }
}

std::optional<std::uint32_t> LeafBvh::Search::next(double limit) {
  constexpr auto farther = [](const Step& a, const Step& b) { return a.t > b.t; };
  const double along = (limit - line_.t_origin) * line_.per_t;
  while (!steps_.empty() && !(static_cast<double>(steps_.front().t) > along)) {
    std::ranges::pop_heap(steps_, farther);
    const std::uint32_t child = steps_.back().child;
    steps_.pop_back();
    if ((child & box_bit) != 0) {
      return child & ~box_bit;
    }
    const Node& node = index_->nodes_[child];
    const Meeting meeting = meet(line_, node);
    for (std::size_t k = 0; k < width; ++k) {
      if (meeting.begin[k] <= meeting.end[k]) {
        steps_.push_back({.t = meeting.begin[k], .child = node.child[k]});
        std::ranges::push_heap(steps_, farther);
      }
    }
  }
  return std::nullopt;
}

}  // namespace raycat
