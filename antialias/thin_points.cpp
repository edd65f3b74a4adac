#include "antialias/thin_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raycat {

ThinPoints::ThinPoints(const std::vector<glm::dvec2>& points, int width, int height, int units)
    : width_(static_cast<std::size_t>(width)) {
  constexpr std::size_t few = 8;
  std::vector<std::pair<std::size_t, glm::ivec2>> placed;
  for (const glm::dvec2& point : points) {
    if (point.x >= 0.0 && point.x < width && point.y >= 0.0 && point.y < height) {
      const std::size_t pixel =
          static_cast<std::size_t>(point.y) * width_ + static_cast<std::size_t>(point.x);
      placed.emplace_back(pixel, glm::ivec2(point * static_cast<double>(units)));
    }
  }
  std::ranges::stable_sort(placed, {}, &std::pair<std::size_t, glm::ivec2>::first);
  for (const auto& [pixel, point] : placed) {
    const std::size_t n = pixels_.size();
    if (n < few || pixels_[n - few] != pixel) {
      pixels_.push_back(pixel);
      points_.push_back(point);
    }
  }
}

std::span<const glm::ivec2> ThinPoints::in(int x, int y) const {
  const std::size_t pixel = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
  const auto [begin, end] = std::ranges::equal_range(pixels_, pixel);
  return std::span(points_).subspan(static_cast<std::size_t>(begin - pixels_.begin()),
                                    static_cast<std::size_t>(end - begin));
}

}  // namespace raycat
