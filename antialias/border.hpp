#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

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

/// What is to be added to a pixel since its border is not straight: it goes on in the pixels beside
/// it, as `rows` have them, and bends from one to the next. A border that bends one way is taken
/// for a parabola; one that turns a corner, or ends, for straight. Costs no ray.
glm::vec4 bend(const std::vector<BorderRow>& rows, int column, int row);

}  // namespace raycat
