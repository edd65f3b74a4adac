#include "antialias/thin_points.hpp"

#include <functional>
#include <numeric>
#include <utility>

namespace raycat {

ThinPoints::ThinPoints(const Sampler& sampler, int width, int height, int units)
    : width_(static_cast<std::size_t>(width)) {
  constexpr std::uint8_t most = 8;
  std::vector<std::uint8_t> count;
  std::vector<std::pair<std::size_t, glm::ivec2>> placed;
  sampler.thin([&](const glm::dvec2& point) {
    if (!(point.x >= 0.0 && point.x < width && point.y >= 0.0 && point.y < height)) {
      return;
    }
    count.resize(width_ * static_cast<std::size_t>(height));
    const std::size_t pixel =
        static_cast<std::size_t>(point.y) * width_ + static_cast<std::size_t>(point.x);
    if (count[pixel] < most) {
      ++count[pixel];
      placed.emplace_back(pixel, glm::ivec2(point * static_cast<double>(units)));
    }
  });
  if (placed.empty()) {
    return;
  }
  begin_.resize(count.size() + 1);
  std::inclusive_scan(count.begin(), count.end(), begin_.begin() + 1, std::plus<>(),
                      std::uint32_t{0});
  points_.resize(placed.size());
  for (const auto& [pixel, point] : placed) {
    points_[begin_[pixel + 1] - count[pixel]--] = point;
  }
}

std::span<const glm::ivec2> ThinPoints::in(int x, int y) const {
  if (points_.empty()) {
    return {};
  }
  const std::size_t pixel = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
  return std::span(points_).subspan(begin_[pixel], begin_[pixel + 1] - begin_[pixel]);
}

}  // namespace raycat
