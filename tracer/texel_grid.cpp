#include "tracer/texel_grid.hpp"

#include <cmath>

#include <glm/common.hpp>

namespace raycat {
namespace {

std::int64_t wrapped(std::int64_t i, std::int64_t size, Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp:
      return glm::clamp<std::int64_t>(i, 0, size - 1);
    case Wrap::mirror: {
      const std::int64_t k = ((i % (2 * size)) + 2 * size) % (2 * size);
      return k < size ? k : 2 * size - 1 - k;
    }
    case Wrap::repeat:
      break;
  }
  return ((i % size) + size) % size;
}

}  // namespace

bool has_texel(const glm::dvec2& uv) noexcept {
  constexpr double farthest = 1e9;
  return std::abs(uv.x) < farthest && std::abs(uv.y) < farthest;
}

std::size_t TexelGrid::texel(std::int64_t x, std::int64_t y) const noexcept {
  const auto column = static_cast<std::size_t>(wrapped(x, width, wrap_s));
  const auto row = static_cast<std::size_t>(wrapped(y, height, wrap_t));
  return row * width + column;
}

std::size_t TexelGrid::nearest(const glm::dvec2& uv) const noexcept {
  return has_texel(uv) ? texel(static_cast<std::int64_t>(std::floor(uv.x * width)),
                               static_cast<std::int64_t>(std::floor(uv.y * height)))
                       : 0;
}

}  // namespace raycat
