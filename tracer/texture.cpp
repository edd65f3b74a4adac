#include "tracer/texture.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "tracer/srgb.hpp"

namespace raycat {
namespace {

std::array<float, 256> decoded() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
  }
  return table;
}

}  // namespace

Texture::Texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
                 Wrap wrap_s, Wrap wrap_t, bool nearest)
    : grid_{.width = width, .height = height, .wrap_s = wrap_s, .wrap_t = wrap_t},
      rgba_(std::move(rgba)),
      nearest_(nearest) {
  if (width == 0 || height == 0 || rgba_.size() != std::size_t{4} * width * height) {
    throw std::invalid_argument(fmt::format("a texture of {}x{} needs {} bytes, but has {}", width,
                                            height, std::size_t{4} * width * height, rgba_.size()));
  }
}

template <class Decode>
glm::vec4 Texture::interpolated(const glm::dvec2& uv, Decode decode) const {
  const std::uint8_t* texels = rgba_.data();
  if (nearest_ || !has_texel(uv)) {
    return decode(texels + 4 * grid_.nearest(uv));
  }
  const double x = uv.x * grid_.width - 0.5;
  const double y = uv.y * grid_.height - 0.5;
  const auto left = static_cast<std::int64_t>(std::floor(x));
  const auto top = static_cast<std::int64_t>(std::floor(y));
  const auto fx = static_cast<float>(x - std::floor(x));
  const auto fy = static_cast<float>(y - std::floor(y));
  const auto at = [&](std::int64_t column, std::int64_t row) {
    return decode(texels + 4 * grid_.texel(column, row));
  };
  return glm::mix(glm::mix(at(left, top), at(left + 1, top), fx),
                  glm::mix(at(left, top + 1), at(left + 1, top + 1), fx), fy);
}

glm::vec4 Texture::sample(const glm::dvec2& uv) const {
  return interpolated(uv, [](const std::uint8_t* p) {
    static const std::array<float, 256> linear = decoded();
    return glm::vec4(linear[p[0]], linear[p[1]], linear[p[2]], static_cast<float>(p[3]) / 255.0f);
  });
}

glm::vec4 Texture::sample_numbers(const glm::dvec2& uv) const {
  return interpolated(
      uv, [](const std::uint8_t* p) { return glm::vec4(p[0], p[1], p[2], p[3]) / 255.0f; });
}

}  // namespace raycat
