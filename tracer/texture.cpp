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

Texture::Texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
                 Wrap wrap_s, Wrap wrap_t, bool nearest)
    : width_(width),
      height_(height),
      rgba_(std::move(rgba)),
      wrap_s_(wrap_s),
      wrap_t_(wrap_t),
      nearest_(nearest) {
  if (width_ == 0 || height_ == 0 || rgba_.size() != std::size_t{4} * width_ * height_) {
    throw std::invalid_argument(fmt::format("a texture of {}x{} needs {} bytes, but has {}", width_,
                                            height_, std::size_t{4} * width_ * height_,
                                            rgba_.size()));
  }
}

glm::vec4 Texture::texel(std::int64_t x, std::int64_t y) const {
  static const std::array<float, 256> linear = decoded();
  const auto column = static_cast<std::size_t>(wrapped(x, width_, wrap_s_));
  const auto row = static_cast<std::size_t>(wrapped(y, height_, wrap_t_));
  const std::uint8_t* p = rgba_.data() + 4 * (row * width_ + column);
  return {linear[p[0]], linear[p[1]], linear[p[2]], static_cast<float>(p[3]) / 255.0f};
}

glm::vec4 Texture::sample(const glm::dvec2& uv) const {
  // Far enough out, coordinates have no fraction left and their texel no place in an int64.
  constexpr double farthest = 1e9;
  if (!(std::abs(uv.x) < farthest) || !(std::abs(uv.y) < farthest)) {
    return texel(0, 0);
  }
  if (nearest_) {
    return texel(static_cast<std::int64_t>(std::floor(uv.x * width_)),
                 static_cast<std::int64_t>(std::floor(uv.y * height_)));
  }
  const double x = uv.x * width_ - 0.5;
  const double y = uv.y * height_ - 0.5;
  const auto left = static_cast<std::int64_t>(std::floor(x));
  const auto top = static_cast<std::int64_t>(std::floor(y));
  const auto fx = static_cast<float>(x - std::floor(x));
  const auto fy = static_cast<float>(y - std::floor(y));
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), fx),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), fx), fy);
}

}  // namespace raycat
