#include "antialias/square_region.hpp"

#include <glm/common.hpp>

namespace raycat {

void SquareRegion::add(const glm::vec2& point, const glm::vec4& value) {
  points[static_cast<std::size_t>(size)] = point;
  values[static_cast<std::size_t>(size)] = value;
  ++size;
}

RegionIntegral integral(const SquareRegion& region) {
  RegionIntegral sum;
  const auto corners = std::span(region.points).first(static_cast<std::size_t>(region.size));
  for_each_triangle(corners, [&](std::size_t i, float triangle) {
    constexpr float third = 1.0f / 3.0f;
    sum.area += triangle;
    sum.centre += triangle * third * (region.points[0] + region.points[i] + region.points[i + 1]);
    sum.mean += triangle * third * (region.values[0] + region.values[i] + region.values[i + 1]);
  });
  if (sum.area > 0.0f) {
    sum.centre /= sum.area;
    sum.mean /= sum.area;
  } else {
    sum.centre = region.points[0];
    sum.mean = region.values[0];
  }
  return sum;
}

SurfaceFit fit(std::span<const std::pair<glm::vec2, glm::vec4>> samples) {
  SurfaceFit out;
  const auto n = static_cast<float>(samples.size());
  glm::vec2 centre(0.0f);
  glm::vec4 low(2.0f);
  glm::vec4 high(-2.0f);
  for (const auto& [point, value] : samples) {
    centre += point / n;
    out.mean += value / n;
    low = glm::min(low, value);
    high = glm::max(high, value);
  }
  out.range = magnitude(high - low);
  float xx = 0.0f;
  float xy = 0.0f;
  float yy = 0.0f;
  glm::vec4 x_values(0.0f);
  glm::vec4 y_values(0.0f);
  for (const auto& [point, value] : samples) {
    const glm::vec2 d = point - centre;
    const glm::vec4 v = value - out.mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    x_values += d.x * v;
    y_values += d.y * v;
  }
  const float determinant = xx * yy - xy * xy;
  if (samples.size() >= 3 && determinant > 1e-3f) {
    const glm::vec4 along_x = (yy * x_values - xy * y_values) / determinant;
    const glm::vec4 along_y = (xx * y_values - xy * x_values) / determinant;
    out.plane =
        SurfaceFit::Plane{out.mean - centre.x * along_x - centre.y * along_y, along_x, along_y};
  }
  return out;
}

}  // namespace raycat
