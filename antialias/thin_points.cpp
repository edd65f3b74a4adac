#include "antialias/thin_points.hpp"

#include <algorithm>
#include <numeric>

namespace raycat {

ThinPoints::ThinPoints(const std::vector<glm::dvec2>& points, int width, int height, int units)
    : width_(static_cast<std::size_t>(width)) {
  constexpr std::uint32_t few = 8;
  if (points.empty()) {
    return;
  }
  const auto visit = [&](const auto& with) {
    for (const glm::dvec2& point : points) {
      if (point.x >= 0.0 && point.x < width && point.y >= 0.0 && point.y < height) {
        with(static_cast<std::size_t>(point.y) * width_ + static_cast<std::size_t>(point.x),
             glm::ivec2(point * static_cast<double>(units)));
      }
    }
  };
  const std::size_t pixels = width_ * static_cast<std::size_t>(height);
  std::vector<std::uint32_t> count(pixels);
  visit([&](std::size_t pixel, const glm::ivec2& /*point*/) {
    count[pixel] = std::min(count[pixel] + 1, few);
  });
  begin_.resize(pixels + 1);
  std::partial_sum(count.begin(), count.end(), begin_.begin() + 1);
  points_.resize(begin_.back());
  visit([&](std::size_t pixel, const glm::ivec2& point) {
    if (count[pixel] > 0) {
      points_[begin_[pixel + 1] - count[pixel]--] = point;
    }
  });
}

std::span<const glm::ivec2> ThinPoints::in(int x, int y) const {
  if (points_.empty()) {
    return {};
  }
  const std::size_t pixel = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
  return std::span(points_).subspan(begin_[pixel], begin_[pixel + 1] - begin_[pixel]);
}

}  // namespace raycat
