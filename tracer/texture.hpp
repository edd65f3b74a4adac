#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "tracer/texel_grid.hpp"

namespace raycat {

/// An image on a surface: 8-bit RGBA, straight (not premultiplied).
class Texture {
 public:
  /// Throws `std::invalid_argument` unless both sizes are positive and `rgba` holds
  /// 4 * width * height bytes.
  Texture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba,
          Wrap wrap_s = Wrap::repeat, Wrap wrap_t = Wrap::repeat, bool nearest = false);

  /// Of an image whose colours are sRGB and whose alpha is linear: linear RGBA at glTF texture
  /// coordinates; bilinear in linear light. The first texel where they are not finite.
  glm::vec4 sample(const glm::dvec2& uv) const;

  /// Of an image that holds numbers instead of colours: these, from 0 to 1, likewise.
  glm::vec4 sample_numbers(const glm::dvec2& uv) const;

 private:
  template <class Decode>
  glm::vec4 interpolated(const glm::dvec2& uv, Decode decode) const;

  TexelGrid grid_;
  std::vector<std::uint8_t> rgba_;
  bool nearest_;
};

}  // namespace raycat
