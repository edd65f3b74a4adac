#include "antialias/border.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace raycat {
namespace {

constexpr std::array<glm::ivec2, 4> beside{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

const Border* border_at(const std::vector<BorderRow>& rows, const glm::ivec2& pixel) {
  return pixel.y >= 0 && pixel.y < static_cast<int>(rows.size())
             ? rows[static_cast<std::size_t>(pixel.y)].find(pixel.x)
             : nullptr;
}

struct Beyond {
  glm::vec2 point{0.0f};
  float exact = 0.0f;
};

// Where the border goes on beyond one of its ends, far enough away to tell something; nothing if a
// pixel on the way there has none.
std::optional<Beyond> beyond(const std::vector<BorderRow>& rows, const glm::ivec2& pixel,
                             const Border& border, std::size_t end) {
  constexpr int most_steps = 3;
  constexpr float far_enough = 0.75f;
  Beyond out{.point = border.ends[end]};
  glm::ivec2 at = pixel;
  int side = border.sides[end];
  for (int step = 0; step < most_steps; ++step) {
    at += beside[static_cast<std::size_t>(side)];
    const Border* next = border_at(rows, at);
    const int opposite = (side + 2) % 4;
    if (next == nullptr || (next->sides[0] != opposite && next->sides[1] != opposite)) {
      break;
    }
    const std::size_t other = next->sides[0] == opposite ? 1 : 0;
    out = {.point = next->ends[other] + glm::vec2(at - pixel),
           .exact = std::max(out.exact, next->exact)};
    side = next->sides[other];
    if (glm::distance(out.point, border.ends[end]) >= far_enough) {
      return out;
    }
  }
  return std::nullopt;
}

// How strongly a parabola bends that is zero at 0 and at `length` and goes through a point outside:
// y = c x (x - length). No more strongly than it must, for a point that is not exact.
float bending(const glm::vec2& point, float length, float exact) {
  const float span = point.x * (point.x - length);
  const float least = std::max(0.0f, std::abs(point.y) - exact);
  return span > 0.0f ? std::copysign(least / span, point.y) : 0.0f;
}

}  // namespace

void BorderRow::set(int column, const std::optional<Border>& border) {
  const auto at = std::ranges::lower_bound(columns_, column);
  const auto index = at - columns_.begin();
  const bool known = at != columns_.end() && *at == column;
  if (known && border) {
    borders_[static_cast<std::size_t>(index)] = *border;
  } else if (known) {
    columns_.erase(at);
    borders_.erase(borders_.begin() + index);
  } else if (border) {
    columns_.insert(at, column);
    borders_.insert(borders_.begin() + index, *border);
  }
}

const Border* BorderRow::find(int column) const {
  const auto at = std::ranges::lower_bound(columns_, column);
  return at != columns_.end() && *at == column
             ? &borders_[static_cast<std::size_t>(at - columns_.begin())]
             : nullptr;
}

float bend(const std::vector<BorderRow>& rows, int column, int row) {
  const glm::ivec2 pixel(column, row);
  const Border* border = border_at(rows, pixel);
  const auto before = beyond(rows, pixel, *border, 0);
  const auto after = beyond(rows, pixel, *border, 1);
  const glm::vec2 chord = border->ends[1] - border->ends[0];
  const float length = glm::length(chord);
  if ((!before && !after) || !(length > 1e-3f)) {
    return 0.0f;
  }
  // Along the chord, and to its left as the picture is seen, with y downwards.
  const glm::vec2 along = chord / length;
  const glm::vec2 left(along.y, -along.x);
  const auto in_frame = [&](const glm::vec2& point) {
    const glm::vec2 from = point - border->ends[0];
    return glm::vec2(glm::dot(from, along), glm::dot(from, left));
  };
  const auto bends = [&](const Beyond& on) {
    return bending(in_frame(on.point), length, 2.0f * std::max(border->exact, on.exact));
  };
  // Where the border is lost from sight on one side, in a pixel with more in it, the other tells.
  const float one = bends(before ? *before : *after);
  const float other = bends(after ? *after : *before);
  if (!(one * other > 0.0f)) {
    return 0.0f;
  }
  const float c = std::abs(one) < std::abs(other) ? one : other;
  // The integral of the parabola, which is below zero where c is above; and no more than a border
  // can bend within a pixel.
  constexpr float most = 0.125f;
  return glm::clamp(-c * length * length * length / 6.0f, -most, most);
}

}  // namespace raycat
