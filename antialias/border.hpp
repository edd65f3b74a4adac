#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "antialias/sampler.hpp"

namespace raycat {

/// The straight border that a pixel has been cut by.
struct Border {
  /// Where it crosses the pixel's sides, in units of the pixel, and which: 0 above, 1 right, 2
  /// below, 3 left.
  std::array<glm::vec2, 2> ends{};
  std::array<int, 2> sides{};
  float exact = 0.0f;    ///< how far the ends may be from where they are said to be
  glm::vec4 left{0.0f};  ///< what is seen on the left of the way from the first end to the second
  glm::vec4 right{0.0f};
  TreeId left_tree{};
  TreeId right_tree{};
};

/// The borders of a row of pixels, by column.
class BorderRow {
 public:
  void set(int column, const std::optional<Border>& border);
  const Border* find(int column) const;

  const std::vector<int>& columns() const noexcept { return columns_; }

 private:
  std::vector<int> columns_;  // ascending
  std::vector<Border> borders_;
};

/// How much of a pixel is on the right of its border that a straight one would have on its left:
/// the border goes on in the pixels beside it, as `rows` have them, and bends from one to the next.
/// One that bends one way is taken for a parabola; one that turns a corner for straight.
/// Costs no ray.
float bend(const std::vector<BorderRow>& rows, int column, int row);

}  // namespace raycat
