#include "edges/refine.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <stdexcept>

namespace raycat {
namespace {

// A point of a level's lattice, whose spacing is 2^-level. As numbers, points are in raster
// order.
using Point = std::uint64_t;

constexpr Point point(std::uint64_t x, std::uint64_t y) { return y << 32 | x; }
constexpr std::uint64_t column(Point p) { return p & 0xffffffff; }
constexpr std::uint64_t row(Point p) { return p >> 32; }

// An edge square of a level.
struct Square {
  std::uint32_t x;
  std::uint32_t y;
  std::array<CategoryId, 4> corners;  // left to right, top to bottom
};

// The middles of the sides and of the whole, on the lattice of the next level.
std::array<Point, 5> new_points(const Square& square) {
  const std::uint64_t x = 2 * std::uint64_t{square.x};
  const std::uint64_t y = 2 * std::uint64_t{square.y};
  return {point(x + 1, y), point(x, y + 1), point(x + 1, y + 1), point(x + 2, y + 1),
          point(x + 1, y + 2)};
}

std::vector<Square> edge_pixels(const CategoryImage& image) {
  std::vector<Square> squares;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::array corners = image.square(x, y);
      if (is_edge(corners)) {
        squares.push_back({.x = static_cast<std::uint32_t>(x),
                           .y = static_cast<std::uint32_t>(y),
                           .corners = corners});
      }
    }
  }
  return squares;
}

// What `squares` need to be broken up, in raster order.
std::vector<Point> points_between(const std::vector<Square>& squares) {
  std::vector<Point> points;
  points.reserve(5 * squares.size());
  for (const Square& square : squares) {
    const std::array<Point, 5> own = new_points(square);
    points.insert(points.end(), own.begin(), own.end());
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// The edge squares among the quarters of `square`. `at` knows the categories of its new points.
template <typename At>
void break_up(const Square& square, const At& at, std::vector<Square>& quarters) {
  const auto& [nw, ne, sw, se] = square.corners;
  const std::array<Point, 5> points = new_points(square);
  const CategoryId n = at(points[0]);
  const CategoryId w = at(points[1]);
  const CategoryId middle = at(points[2]);
  const CategoryId e = at(points[3]);
  const CategoryId s = at(points[4]);
  const std::array<std::array<CategoryId, 4>, 4> corners{{
      {nw, n, w, middle},
      {n, ne, middle, e},
      {w, middle, sw, s},
      {middle, e, s, se},
  }};
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (is_edge(corners[i])) {
      quarters.push_back(
          {.x = 2 * square.x + i % 2, .y = 2 * square.y + i / 2, .corners = corners[i]});
    }
  }
}

EdgeMap map_of(const std::vector<Square>& squares, int width, int height) {
  EdgeMap map{.width = width, .height = height, .pixels = {}};
  const auto columns = static_cast<std::size_t>(width);
  map.pixels.resize(columns * static_cast<std::size_t>(height));
  for (const Square& square : squares) {
    map.pixels[square.y * columns + square.x] = 1;
  }
  return map;
}

}  // namespace

RefinedEdges refine_edges(const CategoryImage& categories, int levels,
                          const CategorySampler& sample) {
  assert(0 <= levels && levels <= most_subpixel_levels);
  if (std::max(categories.width, categories.height) > std::numeric_limits<int>::max() >> levels) {
    throw std::length_error("refined edge maps hold at most 2147483647 subpixels a side");
  }
  RefinedEdges result;
  std::vector<Square> squares = edge_pixels(categories);
  double spacing = 1.0;
  for (int level = 0; level < levels && !squares.empty(); ++level) {
    spacing /= 2.0;
    const std::vector<Point> lattice = points_between(squares);
    std::vector<glm::dvec2> places;
    places.reserve(lattice.size());
    for (const Point p : lattice) {
      places.emplace_back(spacing * static_cast<double>(column(p)),
                          spacing * static_cast<double>(row(p)));
    }
    const std::vector<CategoryId> ids = sample(places);
    assert(ids.size() == places.size());
    result.sampled += ids.size();

    std::vector<Square> quarters;
    quarters.reserve(2 * squares.size());
    for (const Square& square : squares) {
      break_up(
          square,
          [&](Point p) {
            return ids[static_cast<std::size_t>(std::ranges::lower_bound(lattice, p) -
                                                lattice.begin())];
          },
          quarters);
    }
    squares = std::move(quarters);
  }
  result.map = map_of(squares, categories.width << levels, categories.height << levels);
  return result;
}

}  // namespace raycat
