#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>

namespace raycat {

/// What lies beyond the edge of a texture, as glTF samplers have it.
enum class Wrap { repeat, clamp, mirror };

/// The texels of an image: which is where. They are numbered in row order from the top left.
struct TexelGrid {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Wrap wrap_s = Wrap::repeat;
  Wrap wrap_t = Wrap::repeat;

  /// The number of the texel in column `x` of row `y`, inside the image or beyond its edges.
  std::size_t texel(std::int64_t x, std::int64_t y) const noexcept;

  /// The number of the texel at glTF texture coordinates, (0, 0) at the top left; of the first
  /// where they are not finite.
  std::size_t nearest(const glm::dvec2& uv) const noexcept;
};

/// Can a texel be told there? Far enough out, coordinates have no fraction left and their texel no
/// place in an integer.
bool has_texel(const glm::dvec2& uv) noexcept;

}  // namespace raycat
