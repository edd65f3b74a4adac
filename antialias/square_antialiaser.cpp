#include "antialias/square_antialiaser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "antialias/square_cut.hpp"

namespace raycat {
namespace {

constexpr int deepest = 4;  // times that a pixel is subdivided

}  // namespace

SquareAntialiaser::Result& SquareAntialiaser::antialias(int x, int y, float error, Patch* patch) {
  result_ = {};
  samples_.start(error);
  patch_ = patch;
  thin_here_ = thin_.in(x, y);
  found_thin_ = false;
  const Square pixel = pixel_square(samples_.lattice(), x, y);
  result_.mean = integrate(pixel, samples_.corners(pixel));
  result_.refined = samples_.refined();
  return result_;
}

// Is `test(met, from, to)` true of all samples that there are on the square's sides between two
// corners, numbered in turn, of which `from` is the upper or left one?
template <typename Test>
bool SquareAntialiaser::all_on_sides(const Square& square, const Test& test) {
  for (std::size_t i = 0; i < corner_place.size(); ++i) {
    std::size_t from = i;
    std::size_t to = (i + 1) % 4;
    if (corner_place[from].x > corner_place[to].x || corner_place[from].y > corner_place[to].y) {
      std::swap(from, to);
    }
    samples_.lattice().between(square.at + square.size * corner_place[from],
                               square.at + square.size * corner_place[to], on_side_);
    if (!std::ranges::all_of(
            on_side_, [&](const SampleLattice::OnSide& met) { return test(met, from, to); })) {
      return false;
    }
  }
  return true;
}

glm::vec4 SquareAntialiaser::integrate(const Square& square, const Corners& corners) {
  const bool one = std::ranges::all_of(
      corners, [&](const ColourSample* corner) { return corner->tree == corners[0]->tree; });
  if (one || samples_.by_colour()) {
    const auto of_another = [&](const ColourSample& met, const glm::vec2& /*at*/) {
      return met.tree != corners[0]->tree ? std::optional(corners[0]->colour) : std::nullopt;
    };
    if (!samples_.by_colour() &&
        (meets_another(square, corners[0]->tree) || find_thin(square, of_another))) {
      return subdivide(square, corners);
    }
    if (const auto smooth = as_smooth(square, corners)) {
      return *smooth;
    }
    const bool textured = std::ranges::any_of(corners, &ColourSample::textured);
    return textured || samples_.by_colour() ? as_parts(square, corners)
                                            : subdivide(square, corners);
  }
  return as_parts(square, corners);
}

// A square that is not cut: its mean. Corners cover a quarter each of a share of it.
glm::vec4 SquareAntialiaser::whole(const Square& square, const Corners& corners,
                                   const glm::vec4& mean, float share) {
  for (const ColourSample* corner : corners) {
    cover(corner->tree, 0.25f * share * samples_.area(square));
  }
  if (patch_ != nullptr) {
    patch_->add(place(square), samples_.side_length(square),
                {corners[0]->colour, corners[1]->colour, corners[2]->colour, corners[3]->colour},
                mean);
  }
  return mean;
}

// Where a square is in its pixel.
glm::vec2 SquareAntialiaser::place(const Square& square) const {
  return glm::vec2(square.at % samples_.lattice().units()) /
         static_cast<float>(samples_.lattice().units());
}

// In four, each integrated by itself. The samples that this puts on the pixel's borders tell its
// neighbours something.
glm::vec4 SquareAntialiaser::subdivide(const Square& square, const Corners& corners) {
  if (square.size <= samples_.lattice().units() >> deepest) {
    return whole(square, corners, mean_of(corners));
  }
  const int half = square.size / 2;
  const int units = samples_.lattice().units();
  std::array<std::array<const ColourSample*, 3>, 3> grid{
      {{corners[0], nullptr, corners[1]}, {}, {corners[2], nullptr, corners[3]}}};
  for (const glm::ivec2 step : {glm::ivec2(1, 0), {0, 1}, {2, 1}, {1, 2}, {1, 1}}) {
    const glm::ivec2 point = square.at + half * step;
    bool fresh = false;
    grid[static_cast<std::size_t>(step.y)][static_cast<std::size_t>(step.x)] =
        &samples_.sample(point, &fresh);
    if (fresh) {
      result_.borders[0] = result_.borders[0] || (point.x % units == 0 && step.x == 0);
      result_.borders[1] = result_.borders[1] || (point.x % units == 0 && step.x == 2);
      result_.borders[2] = result_.borders[2] || (point.y % units == 0 && step.y == 0);
      result_.borders[3] = result_.borders[3] || (point.y % units == 0 && step.y == 2);
    }
  }
  glm::vec4 sum(0.0f);
  for (std::size_t y = 0; y < 2; ++y) {
    for (std::size_t x = 0; x < 2; ++x) {
      const glm::ivec2 quarter(static_cast<int>(x), static_cast<int>(y));
      sum += integrate({.at = square.at + half * quarter, .size = half},
                       {grid[y][x], grid[y][x + 1], grid[y + 1][x], grid[y + 1][x + 1]});
    }
  }
  return 0.25f * sum;
}

// Has a sample on the square's sides another tree?
bool SquareAntialiaser::meets_another(const Square& square, TreeId tree) {
  return !all_on_sides(square, [&](const SampleLattice::OnSide& met, std::size_t /*from*/,
                                   std::size_t /*to*/) { return met.sample->tree == tree; });
}

// Is there something thin within a square that could be seen and is not taken into account? Where
// `expected(met, at)`, of a sample and its place in units of the square, is not nothing, that is
// the colour taken for it.
template <typename Expected>
bool SquareAntialiaser::find_thin(const Square& square, const Expected& expected) {
  const float area = samples_.area(square);
  const bool found = std::ranges::any_of(thin_here_, [&](const glm::ivec2& point) {
    const glm::ivec2 from = point - square.at;
    if (from.x < 0 || from.y < 0 || from.x >= square.size || from.y >= square.size) {
      return false;
    }
    if (area <= samples_.error()) {  // whatever it is
      may_be_off(area);
      return false;
    }
    const ColourSample& met = samples_.sample(point);
    const std::optional<glm::vec4> taken =
        expected(met, glm::vec2(from) / static_cast<float>(square.size));
    return taken && distance_of(met.colour, *taken) * area > samples_.error();
  });
  found_thin_ = found_thin_ || found;
  return found;
}

// The integral of the quadratic that second differences with the samples one square further tell;
// nothing if it may be off by more than is allowed.
std::optional<glm::vec4> SquareAntialiaser::as_smooth(const Square& square,
                                                      const Corners& corners) {
  const float allowed = samples_.error() / samples_.area(square);
  glm::vec4 correction(0.0f);
  float error = 0.0f;
  for (int axis = 0; axis < 2; ++axis) {
    const glm::ivec2 along = axis == 0 ? glm::ivec2(square.size, 0) : glm::ivec2(0, square.size);
    const std::size_t step = axis == 0 ? 1 : 2;
    glm::vec4 sum(0.0f);
    float largest = 0.0f;
    int count = 0;
    for (int line = 0; line < 2; ++line) {
      const std::size_t first = line == 0 ? 0 : 3 - step;
      const glm::ivec2 start =
          square.at + line * (axis == 0 ? glm::ivec2(0, square.size) : glm::ivec2(square.size, 0));
      const ColourSample& a = *corners[first];
      const ColourSample& b = *corners[first + step];
      const ColourSample* before = samples_.lattice().find(start - along);
      const ColourSample* after = samples_.lattice().find(start + 2 * along);
      const auto add = [&](const ColourSample* outer, const ColourSample& near,
                           const ColourSample& far) {
        if (outer != nullptr && (outer->tree == near.tree || samples_.by_colour())) {
          const glm::vec4 second = outer->colour - 2.0f * near.colour + far.colour;
          sum += second;
          largest = std::max(largest, squared_magnitude(second));
          ++count;
        }
      };
      add(before, a, b);
      add(after, b, a);
    }
    constexpr float twelfth = 1.0f / 12.0f;
    if (count == 0) {
      error += samples_.constants().unseen_bend * farthest(corners);
    } else {
      error += twelfth * std::sqrt(largest);
      correction += twelfth / static_cast<float>(count) * sum;
    }
    if (error > allowed) {
      return std::nullopt;
    }
  }
  may_be_off(error * samples_.area(square));
  return whole(square, corners, mean_of(corners) - correction);
}

glm::vec4 SquareAntialiaser::as_parts(const Square& square, const Corners& corners) {
  const float a = samples_.area(square);
  const CornerLabels labels = label_corners(corners, samples_.by_colour(), samples_.error() / a,
                                            samples_.constants().one_surface);
  if (labels.count == 1 || labels.apart * a / 4.0f < samples_.error()) {
    const auto one = as_one(square, corners, labels.farthest);
    return one ? *one : subdivide(square, corners);
  }
  if (labels.count == 2) {
    // The border of something thin may bend as much as a border can.
    const bool bent = found_thin_ && border_bulge * labels.apart * a > samples_.error();
    const auto two = bent || cluttered(square) ? std::nullopt : as_two(square, corners, labels);
    return two ? *two : subdivide(square, corners);
  }
  const ColourSample& centre = samples_.sample(square.at + square.size / 2);
  if (labels.apart * a / 8.0f < samples_.error()) {
    may_be_off(labels.apart * a / 8.0f);
    cover(centre.tree, 0.5f * a);
    return whole(square, corners, 0.5f * (mean_of(corners) + centre.colour), 0.5f);
  }
  return subdivide(square, corners);
}

// Are there so many categories among the samples around a pixel that a border through it is hardly
// a straight one? Small things are then near, and may be in it without showing at its corners.
bool SquareAntialiaser::cluttered(const Square& square) {
  if (samples_.by_colour() || !samples_.is_pixel(square)) {
    return false;
  }
  constexpr std::size_t many = 6;
  std::array<TreeId, many> met{};
  std::size_t count = 0;
  samples_.for_each_around(square, [&](const glm::ivec2&, const ColourSample& sample) {
    const auto end = met.begin() + static_cast<std::ptrdiff_t>(count);
    if (count < many && std::find(met.begin(), end, sample.tree) == end) {
      met[count++] = sample.tree;
    }
  });
  return count == many;
}

// An edge that cannot be seen; nothing if a sample on the sides is far from what the corners tell.
std::optional<glm::vec4> SquareAntialiaser::as_one(const Square& square, const Corners& corners,
                                                   float greatest) {
  const float allowed = std::max(4.0f * samples_.error() / samples_.area(square), greatest);
  const bool expected =
      all_on_sides(square, [&](const SampleLattice::OnSide& met, std::size_t from, std::size_t to) {
        const float at = static_cast<float>(met.from_start) / static_cast<float>(square.size);
        const glm::vec4 between =
            glm::mix(corners[corner_turn[from]]->colour, corners[corner_turn[to]]->colour, at);
        return distance_of(met.sample->colour, between) <= allowed;
      });
  if (!expected) {
    return std::nullopt;
  }
  may_be_off(0.25f * greatest * samples_.area(square));
  return whole(square, corners, mean_of(corners));
}

// Two parts with a straight border between them; nothing if something is against it.
std::optional<glm::vec4> SquareAntialiaser::as_two(const Square& square, const Corners& corners,
                                                   const CornerLabels& labels) {
  const auto two = cut(samples_, square, corners, labels);
  if (!two) {
    return std::nullopt;
  }
  const auto in_other_part = [&](const ColourSample& met, const glm::vec2& at) {
    const SquareCut::Part& part = two->parts[two->part_at(at)];
    return label_of(met, corners, labels, false) != part.region.label
               ? std::optional(part.integral.mean)
               : std::nullopt;
  };
  if (!samples_.by_colour() && find_thin(square, in_other_part)) {
    return std::nullopt;
  }
  may_be_off(two->error);
  for (const auto& [region, integral, surface] : two->parts) {
    // Each corner stands for its part of what its label covers.
    const float share = integral.area * samples_.area(square) /
                        static_cast<float>(std::ranges::count(labels.of, region.label));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (labels.of[i] == region.label) {
        cover(corners[i]->tree, share);
      }
    }
    if (patch_ != nullptr) {
      const auto plane = surface.plane.value_or(SurfaceFit::Plane{});
      patch_->add(place(square), samples_.side_length(square), region, integral, plane[1],
                  plane[2]);
    }
  }
  if (samples_.is_pixel(square)) {
    result_.cut = two->border(corners, labels);
  }
  return two->mean();
}

}  // namespace raycat
