#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace raycat {

/// What lies beyond the edge of a texture, as glTF samplers have it.
enum class Wrap { repeat, clamp, mirror };

/// An image on a surface: 8-bit RGBA in row order from the top left, colour in sRGB, alpha
/// linear, straight (not premultiplied).
class Texture {
 public:
  /// Throws `std::invalid_argument` unless both sizes are positive and `rgba` holds
  /// 4 * width * height bytes.
  Texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
          Wrap wrap_s = Wrap::repeat, Wrap wrap_t = Wrap::repeat, bool nearest = false);

  /// Linear RGBA at glTF texture coordinates, (0, 0) at the top left; bilinear in linear light.
  /// Coordinates that are not finite give the first texel.
  glm::vec4 sample(const glm::dvec2& uv) const;

 private:
  glm::vec4 texel(std::int64_t x, std::int64_t y) const;

  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<std::uint8_t> rgba_;
  Wrap wrap_s_;
  Wrap wrap_t_;
  bool nearest_;
};

}  // namespace raycat
