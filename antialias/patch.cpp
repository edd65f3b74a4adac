#include "antialias/patch.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace raycat {
namespace {

constexpr float cells = Patch::side;

// A convex polygon; one of five corners that is cut by four lines has nine at most.
struct Polygon {
  std::array<glm::vec2, 9> points{};
  std::size_t size = 0;
};

// What is left of a polygon where coordinate `axis` is at least `bound`, or with `sign` -1 at most.
Polygon cut(const Polygon& polygon, int axis, float bound, float sign) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const glm::vec2& from = polygon.points[i];
    const glm::vec2& to = polygon.points[(i + 1) % polygon.size];
    const float before = sign * (from[axis] - bound);
    const float after = sign * (to[axis] - bound);
    if (before >= 0.0f) {
      out.points[out.size++] = from;
    }
    if ((before < 0.0f) != (after < 0.0f) && out.size < out.points.size()) {
      out.points[out.size++] = glm::mix(from, to, before / (before - after));
    }
  }
  return out;
}

struct Piece {
  float area = 0.0f;
  glm::vec2 centre{0.0f};
};

Piece piece_of(const Polygon& polygon) {
  Piece out;
  const auto points = std::span(polygon.points).first(polygon.size);
  for_each_triangle(points, [&](std::size_t i, float triangle) {
    out.area += triangle;
    out.centre += triangle / 3.0f * (points[0] + points[i] + points[i + 1]);
  });
  out.centre = out.area > 0.0f ? out.centre / out.area : glm::vec2(0.0f);
  return out;
}

}  // namespace

void Patch::add(const glm::vec2& at, float size, const std::array<glm::vec4, 4>& corners,
                const glm::vec4& mean) {
  const glm::vec4 rest = mean - 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
  const glm::ivec2 first(at * cells);
  const int across = std::max(1, static_cast<int>(size * cells));
  const float share = size * size * cells * cells / static_cast<float>(across * across);
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < across; ++i) {
      const glm::vec2 middle = (glm::vec2(i, j) + 0.5f) / static_cast<float>(across);
      const glm::vec4 value = glm::mix(glm::mix(corners[0], corners[1], middle.x),
                                       glm::mix(corners[2], corners[3], middle.x), middle.y);
      cell(first.x + i, first.y + j) += share * (value + rest);
    }
  }
}

void Patch::add(const glm::vec2& at, float size, const SquareRegion& region,
                const RegionIntegral& integral, const glm::vec4& along_x,
                const glm::vec4& along_y) {
  Polygon whole;
  for (int i = 0; i < region.size; ++i) {
    whole.points[whole.size++] = region.points[static_cast<std::size_t>(i)];
  }
  const glm::ivec2 first(at * cells);
  const int across = std::max(1, static_cast<int>(size * cells));
  const float step = 1.0f / static_cast<float>(across);
  for (int j = 0; j < across; ++j) {
    const float top = static_cast<float>(j) * step;
    const Polygon line = cut(cut(whole, 1, top, 1.0f), 1, top + step, -1.0f);
    for (int i = 0; i < across && line.size > 2; ++i) {
      const float left = static_cast<float>(i) * step;
      const Piece piece = piece_of(cut(cut(line, 0, left, 1.0f), 0, left + step, -1.0f));
      const glm::vec2 from = piece.centre - integral.centre;
      cell(first.x + i, first.y + j) += piece.area * size * size * cells * cells *
                                        (integral.mean + from.x * along_x + from.y * along_y);
    }
  }
}

void Patch::shift(const glm::vec4& more) {
  for (glm::vec4& cell : cells_) {
    cell += more;
  }
}

}  // namespace raycat
