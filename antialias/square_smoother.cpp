#include "antialias/square_smoother.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace raycat {
namespace {

constexpr int deepest = 4;  // times that a pixel is parted

// A square's corners in turn, as numbers in `Corners`, and where they are.
constexpr std::array<std::size_t, 4> turn{0, 1, 3, 2};
constexpr std::array<glm::ivec2, 4> turn_at{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

}  // namespace

SquareSmoother::Result SquareSmoother::smooth(int x, int y, float error, Patch* patch) {
  result_ = {};
  error_ = error;
  patch_ = patch;
  result_.mean = integrate(pixel_square(lattice_, x, y));
  return result_;
}

float SquareSmoother::area(const Square& square) const {
  const float side = static_cast<float>(square.size) / static_cast<float>(lattice_.units());
  return side * side;
}

const ColourSample& SquareSmoother::sample(const glm::ivec2& point) {
  bool fresh = false;
  const ColourSample& sample = lattice_.at(point, worker_, &fresh);
  result_.refined = result_.refined || fresh;
  return sample;
}

// Calls `visit(place, sample)` for those of the sixteen samples of a square and around it that are
// there; places are in sides of the square, from its first corner.
template <typename Visit>
void SquareSmoother::for_each_around(const Square& square, const Visit& visit) {
  for (int j = -1; j <= 2; ++j) {
    for (int i = -1; i <= 2; ++i) {
      const glm::ivec2 place(i, j);
      if (const ColourSample* sample = lattice_.find(square.at + square.size * place)) {
        visit(place, *sample);
      }
    }
  }
}

glm::vec4 SquareSmoother::integrate(const Square& square) {
  const Corners corners = square.corners(lattice_, worker_);
  const bool one = std::ranges::all_of(
      corners, [&](const ColourSample* corner) { return corner->tree == corners[0]->tree; });
  if (one || !settings_.categories) {
    if (settings_.categories && meets_another(square, corners[0]->tree)) {
      return part(square);
    }
    if (const auto smooth = as_smooth(square, corners)) {
      return *smooth;
    }
    const bool textured = std::ranges::any_of(corners, &ColourSample::textured);
    return textured || !settings_.categories ? as_parts(square, corners) : part(square);
  }
  return as_parts(square, corners);
}

// A square that is not cut: its mean. Corners cover a quarter each of a share of it.
glm::vec4 SquareSmoother::whole(const Square& square, const Corners& corners, const glm::vec4& mean,
                                float share) {
  for (const ColourSample* corner : corners) {
    cover(corner->tree, 0.25f * share * area(square));
  }
  if (patch_ != nullptr) {
    patch_->add(place(square), std::sqrt(area(square)),
                {corners[0]->colour, corners[1]->colour, corners[2]->colour, corners[3]->colour},
                mean);
  }
  return mean;
}

// Where a square is in its pixel.
glm::vec2 SquareSmoother::place(const Square& square) const {
  return glm::vec2(square.at % lattice_.units()) / static_cast<float>(lattice_.units());
}

// In four, each integrated by itself. The samples that this puts on the pixel's borders tell its
// neighbours something.
glm::vec4 SquareSmoother::part(const Square& square) {
  if (square.size <= lattice_.units() >> deepest) {
    const Corners corners = square.corners(lattice_, worker_);
    return whole(square, corners, mean_of(corners));
  }
  const int half = square.size / 2;
  const int units = lattice_.units();
  for (const glm::ivec2 step : {glm::ivec2(1, 0), {0, 1}, {2, 1}, {1, 2}, {1, 1}}) {
    const glm::ivec2 point = square.at + half * step;
    bool fresh = false;
    lattice_.at(point, worker_, &fresh);
    if (fresh) {
      result_.refined = true;
      result_.borders[0] = result_.borders[0] || (point.x % units == 0 && step.x == 0);
      result_.borders[1] = result_.borders[1] || (point.x % units == 0 && step.x == 2);
      result_.borders[2] = result_.borders[2] || (point.y % units == 0 && step.y == 0);
      result_.borders[3] = result_.borders[3] || (point.y % units == 0 && step.y == 2);
    }
  }
  glm::vec4 sum(0.0f);
  for (const glm::ivec2 quarter : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    sum += integrate({.at = square.at + half * quarter, .size = half});
  }
  return 0.25f * sum;
}

// Has a sample on the square's sides another tree?
bool SquareSmoother::meets_another(const Square& square, TreeId tree) {
  for (std::size_t i = 0; i < turn_at.size(); ++i) {
    glm::ivec2 start = square.at + square.size * turn_at[i];
    glm::ivec2 end = square.at + square.size * turn_at[(i + 1) % 4];
    if (start.x > end.x || start.y > end.y) {
      std::swap(start, end);
    }
    lattice_.between(start, end, on_side_);
    if (std::ranges::any_of(
            on_side_, [&](const SampleLattice::OnSide& met) { return met.sample->tree != tree; })) {
      return true;
    }
  }
  return false;
}

// The integral of the quadratic that second differences with the samples one square further tell;
// nothing if it may be off by more than is allowed.
std::optional<glm::vec4> SquareSmoother::as_smooth(const Square& square, const Corners& corners) {
  const float allowed = error_ / area(square);
  // Half of the greatest difference cannot be exceeded by much, and most squares are flat.
  constexpr float without_neighbours = 0.08f;
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
      const ColourSample* before = lattice_.find(start - along);
      const ColourSample* after = lattice_.find(start + 2 * along);
      const auto add = [&](const ColourSample* outer, const ColourSample& near,
                           const ColourSample& far) {
        if (outer != nullptr && (outer->tree == near.tree || !settings_.categories)) {
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
      error += without_neighbours * farthest(corners);
    } else {
      error += twelfth * std::sqrt(largest);
      correction += twelfth / static_cast<float>(count) * sum;
    }
  }
  if (error > allowed) {
    return std::nullopt;
  }
  may_be_off(error * area(square));
  return whole(square, corners, mean_of(corners) - correction);
}

glm::vec4 SquareSmoother::as_parts(const Square& square, const Corners& corners) {
  const float a = area(square);
  const CornerLabels labels = label_corners(corners, !settings_.categories, error_ / a, 0.15f);
  if (labels.count == 1 || labels.apart * a / 4.0f < error_) {
    const auto one = as_one(square, corners, labels.farthest);
    return one ? *one : part(square);
  }
  if (labels.count == 2) {
    const auto two = cluttered(square) ? std::nullopt : as_two(square, corners, labels);
    return two ? *two : part(square);
  }
  const ColourSample& centre = sample(square.at + square.size / 2);
  if (labels.apart * a / 8.0f < error_) {
    may_be_off(labels.apart * a / 8.0f);
    cover(centre.tree, 0.5f * a);
    return whole(square, corners, 0.5f * (mean_of(corners) + centre.colour), 0.5f);
  }
  return part(square);
}

// Are there so many categories among the samples around a pixel that a border through it is hardly
// a straight one? Small things are then near, and may be in it without showing at its corners.
bool SquareSmoother::cluttered(const Square& square) {
  if (!settings_.categories || square.size < lattice_.units()) {
    return false;
  }
  constexpr std::size_t many = 6;
  std::array<TreeId, many> met{};
  std::size_t count = 0;
  for_each_around(square, [&](const glm::ivec2&, const ColourSample& sample) {
    const auto end = met.begin() + static_cast<std::ptrdiff_t>(count);
    if (count < many && std::find(met.begin(), end, sample.tree) == end) {
      met[count++] = sample.tree;
    }
  });
  return count == many;
}

// An edge that cannot be seen; nothing if a sample on the sides is far from what the corners tell.
std::optional<glm::vec4> SquareSmoother::as_one(const Square& square, const Corners& corners,
                                                float greatest) {
  const float allowed = std::max(4.0f * error_ / area(square), greatest);
  for (std::size_t i = 0; i < turn_at.size(); ++i) {
    std::size_t from = i;
    std::size_t to = (i + 1) % 4;
    if (turn_at[from].x > turn_at[to].x || turn_at[from].y > turn_at[to].y) {
      std::swap(from, to);
    }
    lattice_.between(square.at + square.size * turn_at[from], square.at + square.size * turn_at[to],
                     on_side_);
    for (const SampleLattice::OnSide& met : on_side_) {
      const float at = static_cast<float>(met.from_start) / static_cast<float>(square.size);
      const glm::vec4 expected =
          glm::mix(corners[turn[from]]->colour, corners[turn[to]]->colour, at);
      if (distance_of(met.sample->colour, expected) > allowed) {
        return std::nullopt;
      }
    }
  }
  may_be_off(0.25f * greatest * area(square));
  return whole(square, corners, mean_of(corners));
}

// Halves the part of a side in which the label changes, `steps` times. Nothing if a sample is of
// neither label and of a colour of its own.
std::optional<SquareSmoother::Crossing> SquareSmoother::cross(const Square& square,
                                                              const Corners& corners,
                                                              const CornerLabels& labels, int side,
                                                              int steps) {
  const auto i = static_cast<std::size_t>(side);
  const std::size_t j = (i + 1) % 4;
  const glm::ivec2 start = square.at + square.size * turn_at[i];
  const glm::ivec2 along = turn_at[j] - turn_at[i];
  const ColourSample* at_low = corners[turn[i]];
  const ColourSample* at_high = corners[turn[j]];
  const int before = labels.of[turn[i]];
  const int after = labels.of[turn[j]];
  const float ends = distance_of(at_low->colour, at_high->colour);
  const float a = area(square);
  int low = 0;
  int high = square.size;
  for (int step = 0; step < steps && high - low > 1; ++step) {
    const int middle = (low + high) / 2;
    const ColourSample& met = sample(start + middle * along);
    int label = label_of(met, corners, labels, !settings_.categories);
    if (label != before && label != after) {
      const float to_before = distance_of(met.colour, at_low->colour);
      const float to_after = distance_of(met.colour, at_high->colour);
      const float nearest = std::min(to_before, to_after);
      if (!(nearest < 0.25f * ends || nearest * a / 4.0f < error_)) {
        return std::nullopt;
      }
      label = to_before <= to_after ? before : after;
    }
    if (label == before) {
      low = middle;
      at_low = &met;
    } else {
      high = middle;
      at_high = &met;
    }
  }
  return Crossing{.at = 0.5f * static_cast<float>(low + high) / static_cast<float>(square.size),
                  .exact = 0.5f * static_cast<float>(high - low) / static_cast<float>(square.size),
                  .before = at_low->colour,
                  .after = at_high->colour};
}

// The same by rays that only tell the two trees apart; what is beside the crossing, the surfaces of
// its labels show. Nothing if a ray is of neither.
std::optional<SquareSmoother::Crossing> SquareSmoother::cross_cheaply(
    const Square& square, const Corners& corners, const std::array<SurfaceFit, 4>& surfaces,
    const CornerLabels& labels, int side, int steps) {
  const auto i = static_cast<std::size_t>(side);
  const std::size_t j = (i + 1) % 4;
  const glm::ivec2 start = square.at + square.size * turn_at[i];
  const glm::ivec2 along = turn_at[j] - turn_at[i];
  const TreeId before = corners[turn[i]]->tree;
  const TreeId after = corners[turn[j]]->tree;
  int low = 0;
  int high = square.size;
  for (int step = 0; step < steps && high - low > 1; ++step) {
    const int middle = (low + high) / 2;
    const auto met = lattice_.side(start + middle * along, before, after, worker_);
    if (!met) {
      return std::nullopt;
    }
    (*met == before ? low : high) = middle;
  }
  result_.refined = true;
  const float at = 0.5f * static_cast<float>(low + high) / static_cast<float>(square.size);
  const glm::vec2 point = glm::mix(glm::vec2(turn_at[i]), glm::vec2(turn_at[j]), at);
  return Crossing{.at = at,
                  .exact = 0.5f * static_cast<float>(high - low) / static_cast<float>(square.size),
                  .before = surfaces[static_cast<std::size_t>(labels.of[turn[i]])].at(point),
                  .after = surfaces[static_cast<std::size_t>(labels.of[turn[j]])].at(point)};
}

// What the samples of each label show among those around a square.
std::array<SurfaceFit, 4> SquareSmoother::surfaces_around(const Square& square,
                                                          const Corners& corners,
                                                          const CornerLabels& labels) {
  std::array<std::array<std::pair<glm::vec2, glm::vec4>, 16>, 4> met;
  std::array<std::size_t, 4> count{};
  for_each_around(square, [&](const glm::ivec2& at, const ColourSample& sample) {
    const int label = label_of(sample, corners, labels, !settings_.categories);
    if (label >= 0) {
      const auto i = static_cast<std::size_t>(label);
      met[i][count[i]++] = {glm::vec2(at), sample.colour};
    }
  });
  std::array<SurfaceFit, 4> surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (count[i] > 0) {
      surfaces[i] = fit(std::span(met[i]).first(count[i]));
    }
  }
  return surfaces;
}

// Two regions with a straight border between them; nothing if something is against it.
std::optional<glm::vec4> SquareSmoother::as_two(const Square& square, const Corners& corners,
                                                const CornerLabels& labels) {
  const float a = area(square);
  std::array<int, 4> crossed{};
  int crossings = 0;
  for (int side = 0; side < 4; ++side) {
    const auto i = static_cast<std::size_t>(side);
    if (labels.of[turn[i]] != labels.of[turn[(i + 1) % 4]]) {
      crossed[static_cast<std::size_t>(crossings++)] = side;
    }
  }
  if (crossings != 2) {
    return std::nullopt;
  }
  const int steps =
      std::max(1, static_cast<int>(std::ceil(std::log2(labels.apart * a / (4.0f * error_)))));
  const std::array<SurfaceFit, 4> surfaces = surfaces_around(square, corners, labels);
  const bool flat = std::ranges::all_of(labels.of, [&](int label) {
    return surfaces[static_cast<std::size_t>(label)].range * a <= error_;
  });
  const auto crossing = [&](int side) {
    const auto i = static_cast<std::size_t>(side);
    if (settings_.categories && flat &&
        lattice_.sampler().tells_cheaply(corners[turn[i]]->tree,
                                         corners[turn[(i + 1) % 4]]->tree)) {
      if (const auto cheap = cross_cheaply(square, corners, surfaces, labels, side, steps)) {
        return std::optional(*cheap);
      }
    }
    return cross(square, corners, labels, side, steps);
  };
  const auto first = crossing(crossed[0]);
  const auto second = first ? crossing(crossed[1]) : std::nullopt;
  if (!second) {
    return std::nullopt;
  }
  const auto point_on = [](int side, float at) {
    const auto i = static_cast<std::size_t>(side);
    return glm::mix(glm::vec2(turn_at[i]), glm::vec2(turn_at[(i + 1) % 4]), at);
  };
  const glm::vec2 start = point_on(crossed[0], first->at);
  const glm::vec2 end = point_on(crossed[1], second->at);
  SquareRegion regions[2];
  const auto add_corner = [&](SquareRegion& region, int corner) {
    const auto i = static_cast<std::size_t>(corner % 4);
    region.label = labels.of[turn[i]];
    region.add(glm::vec2(turn_at[i]), corners[turn[i]]->colour);
  };
  regions[0].add(start, first->after);
  for (int corner = crossed[0] + 1; corner <= crossed[1]; ++corner) {
    add_corner(regions[0], corner);
  }
  regions[0].add(end, second->before);
  regions[1].add(end, second->after);
  for (int corner = crossed[1] + 1; corner <= crossed[0] + 4; ++corner) {
    add_corner(regions[1], corner);
  }
  regions[1].add(start, first->before);

  float may_be = std::ldexp(labels.apart * a / 4.0f, -steps);
  glm::vec4 sum(0.0f);
  std::array<RegionIntegral, 2> parts;
  std::array<const SurfaceFit*, 2> seen{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = integral(regions[i]);
    sum += parts[i].area * parts[i].mean;
    seen[i] = &surfaces[static_cast<std::size_t>(regions[i].label)];
    const glm::vec4 expected = seen[i]->at(parts[i].centre);
    const float off =
        seen[i]->plane ? magnitude(expected - parts[i].mean) * parts[i].area * a : 0.0f;
    if (off > error_) {
      return std::nullopt;
    }
    may_be = std::max(may_be, off);
  }
  constexpr float bulge = 0.08f;  // the part of a square by which a border may miss its chord
  if (bulge * labels.apart * a <= error_) {
    may_be = std::max(may_be, bulge * labels.apart * a);
  } else {
    const ColourSample& centre = sample(square.at + square.size / 2);
    const glm::vec2 chord = end - start;
    const auto side_of = [&](const glm::vec2& point) {
      const glm::vec2 from = point - start;
      return chord.x * from.y - chord.y * from.x > 0.0f;
    };
    const bool in_first = side_of(glm::vec2(0.5f)) == side_of(parts[0].centre);
    const std::size_t is = in_first ? 0 : 1;
    const int met = label_of(centre, corners, labels, !settings_.categories);
    float error = 0.0f;
    if (met == regions[1 - is].label) {
      error = parts[is].area < 0.62f
                  ? std::max(0.0f, 2.0f * (parts[is].area - 0.45f)) * labels.apart
                  : labels.apart;
    } else {
      const glm::vec4 expected = seen[is]->plane ? seen[is]->at(glm::vec2(0.5f)) : parts[is].mean;
      error = magnitude(centre.colour - expected);
    }
    const float off = error * parts[is].area * a / 2.0f;
    if (off > error_) {
      return std::nullopt;
    }
    may_be = std::max(may_be, off);
  }
  may_be_off(may_be);
  // Each corner stands for its part of what its label covers.
  for (std::size_t r = 0; r < parts.size(); ++r) {
    const int label = regions[r].label;
    const float share =
        parts[r].area * a / static_cast<float>(std::ranges::count(labels.of, label));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (labels.of[i] == label) {
        cover(corners[i]->tree, share);
      }
    }
  }
  for (std::size_t r = 0; patch_ != nullptr && r < parts.size(); ++r) {
    const auto change = [&](std::size_t axis) {
      return seen[r]->plane ? (*seen[r]->plane)[axis] : glm::vec4(0.0f);
    };
    patch_->add(place(square), std::sqrt(a), regions[r], parts[r], change(1), change(2));
  }
  if (square.size == lattice_.units()) {
    const glm::vec2 middle = 0.5f * (start + end);
    const glm::vec2 from = parts[0].centre - start;
    const bool first_is_left = (end - start).x * from.y - (end - start).y * from.x < 0.0f;
    const auto on = [&](bool left) {
      const std::size_t i = left == first_is_left ? 0 : 1;
      return seen[i]->plane ? seen[i]->at(middle) : parts[i].mean;
    };
    const auto tree_on = [&](bool left) {
      const int label = regions[left == first_is_left ? 0 : 1].label;
      const auto corner = std::ranges::find(labels.of, label) - labels.of.begin();
      return corners[static_cast<std::size_t>(corner)]->tree;
    };
    result_.cut = Border{.ends = {start, end},
                         .sides = {crossed[0], crossed[1]},
                         .exact = std::max(first->exact, second->exact),
                         .left = on(true),
                         .right = on(false),
                         .left_tree = tree_on(true),
                         .right_tree = tree_on(false)};
  }
  return sum;
}

}  // namespace raycat
