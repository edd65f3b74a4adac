#include "antialias/square_cut.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/common.hpp>

namespace raycat {
namespace {

// Where the border between two labels crosses a side.
struct Crossing {
  float at = 0.5f;         // from the side's start, of its length
  float exact = 0.0f;      // how far it may be from there
  glm::vec4 before{0.0f};  // what is just before it and just after
  glm::vec4 after{0.0f};
};

// Halves the part of a side in which the label changes, `steps` times. Nothing if a sample is of
// neither label and of a colour of its own.
std::optional<Crossing> cross(PixelSamples& samples, const Square& square, const Corners& corners,
                              const CornerLabels& labels, int side, int steps) {
  const auto i = static_cast<std::size_t>(side);
  const std::size_t j = (i + 1) % 4;
  const glm::ivec2 start = square.at + square.size * corner_place[i];
  const glm::ivec2 along = corner_place[j] - corner_place[i];
  const ColourSample* at_low = corners[corner_turn[i]];
  const ColourSample* at_high = corners[corner_turn[j]];
  const int before = labels.of[corner_turn[i]];
  const int after = labels.of[corner_turn[j]];
  const float ends = distance_of(at_low->colour, at_high->colour);
  const float a = samples.area(square);
  int low = 0;
  int high = square.size;
  for (int step = 0; step < steps && high - low > 1; ++step) {
    const int middle = (low + high) / 2;
    const ColourSample& met = samples.sample(start + middle * along);
    int label = label_of(met, corners, labels, samples.by_colour());
    if (label != before && label != after) {
      const float to_before = distance_of(met.colour, at_low->colour);
      const float to_after = distance_of(met.colour, at_high->colour);
      const float nearest = std::min(to_before, to_after);
      if (!(nearest < 0.25f * ends || nearest * a / 4.0f < samples.error())) {
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
std::optional<Crossing> cross_cheaply(PixelSamples& samples, const Square& square,
                                      const Corners& corners,
                                      const std::array<SurfaceFit, 4>& surfaces,
                                      const CornerLabels& labels, int side, int steps) {
  const auto i = static_cast<std::size_t>(side);
  const std::size_t j = (i + 1) % 4;
  const glm::ivec2 start = square.at + square.size * corner_place[i];
  const glm::ivec2 along = corner_place[j] - corner_place[i];
  const TreeId before = corners[corner_turn[i]]->tree;
  const TreeId after = corners[corner_turn[j]]->tree;
  int low = 0;
  int high = square.size;
  for (int step = 0; step < steps && high - low > 1; ++step) {
    const int middle = (low + high) / 2;
    const auto met = samples.side(start + middle * along, before, after);
    if (!met) {
      return std::nullopt;
    }
    (*met == before ? low : high) = middle;
  }
  const float at = 0.5f * static_cast<float>(low + high) / static_cast<float>(square.size);
  const glm::vec2 point = glm::mix(glm::vec2(corner_place[i]), glm::vec2(corner_place[j]), at);
  return Crossing{.at = at,
                  .exact = 0.5f * static_cast<float>(high - low) / static_cast<float>(square.size),
                  .before = surfaces[static_cast<std::size_t>(labels.of[corner_turn[i]])].at(point),
                  .after = surfaces[static_cast<std::size_t>(labels.of[corner_turn[j]])].at(point)};
}

// What the samples of each label show among those around a square.
std::array<SurfaceFit, 4> surfaces_around(const PixelSamples& samples, const Square& square,
                                          const Corners& corners, const CornerLabels& labels) {
  std::array<std::array<std::pair<glm::vec2, glm::vec4>, 16>, 4> met;
  std::array<std::size_t, 4> count{};
  samples.for_each_around(square, [&](const glm::ivec2& at, const ColourSample& sample) {
    const int label = label_of(sample, corners, labels, samples.by_colour());
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

// The sides on which the label changes, if they are two.
std::optional<std::array<int, 2>> crossed_sides(const CornerLabels& labels) {
  std::array<int, 4> crossed{};
  std::size_t count = 0;
  for (int side = 0; side < 4; ++side) {
    const auto i = static_cast<std::size_t>(side);
    if (labels.of[corner_turn[i]] != labels.of[corner_turn[(i + 1) % 4]]) {
      crossed[count++] = side;
    }
  }
  return count == 2 ? std::optional(std::array{crossed[0], crossed[1]}) : std::nullopt;
}

// Both parts, with what is just beside the crossings.
void divide(const Corners& corners, const CornerLabels& labels, const Crossing& first,
            const Crossing& second, SquareCut& out) {
  const auto add_corners = [&](SquareRegion& region, int begin, int end) {
    for (int corner = begin; corner <= end; ++corner) {
      const auto i = static_cast<std::size_t>(corner % 4);
      region.label = labels.of[corner_turn[i]];
      region.add(glm::vec2(corner_place[i]), corners[corner_turn[i]]->colour);
    }
  };
  SquareRegion& one = out.parts[0].region;
  SquareRegion& other = out.parts[1].region;
  one.add(out.ends[0], first.after);
  add_corners(one, out.sides[0] + 1, out.sides[1]);
  one.add(out.ends[1], second.before);
  other.add(out.ends[1], second.after);
  add_corners(other, out.sides[1] + 1, out.sides[0] + 4);
  other.add(out.ends[0], first.before);
}

// What a sample in the middle says against the cut, as an error of the pixel.
float error_in_middle(PixelSamples& samples, const Square& square, const Corners& corners,
                      const CornerLabels& labels, const SquareCut& cut) {
  const ColourSample& centre = samples.sample(square.at + square.size / 2);
  const std::size_t part = cut.part_at(glm::vec2(0.5f));
  const SquareCut::Part& is = cut.parts[part];
  const SquareCut::Part& other = cut.parts[1 - part];
  float error = 0.0f;
  if (label_of(centre, corners, labels, samples.by_colour()) == other.region.label) {
    const AdaptiveConstants& constants = samples.constants();
    error = is.integral.area < constants.bent_border
                ? std::max(0.0f, 2.0f * (is.integral.area - constants.harmless_bend)) * labels.apart
                : labels.apart;
  } else {
    const glm::vec4 expected = is.surface.plane ? is.surface.at(glm::vec2(0.5f)) : is.integral.mean;
    error = magnitude(centre.colour - expected);
  }
  return error * is.integral.area * samples.area(square) / 2.0f;
}

}  // namespace

std::size_t SquareCut::part_at(const glm::vec2& point) const {
  const glm::vec2 chord = ends[1] - ends[0];
  const auto side_of = [&](const glm::vec2& at) {
    const glm::vec2 from = at - ends[0];
    return chord.x * from.y - chord.y * from.x > 0.0f;
  };
  return side_of(point) == side_of(parts[0].integral.centre) ? 0 : 1;
}

Border SquareCut::border(const Corners& corners, const CornerLabels& labels) const {
  const glm::vec2 middle = 0.5f * (ends[0] + ends[1]);
  const glm::vec2 along = ends[1] - ends[0];
  const glm::vec2 from = parts[0].integral.centre - ends[0];
  const bool first_is_left = along.x * from.y - along.y * from.x < 0.0f;
  const auto on = [&](const Part& part) {
    return part.surface.plane ? part.surface.at(middle) : part.integral.mean;
  };
  const auto tree_on = [&](const Part& part) {
    const auto corner = std::ranges::find(labels.of, part.region.label) - labels.of.begin();
    return corners[static_cast<std::size_t>(corner)]->tree;
  };
  const Part& left = parts[first_is_left ? 0 : 1];
  const Part& right = parts[first_is_left ? 1 : 0];
  return {.ends = ends,
          .sides = sides,
          .exact = exact,
          .left = on(left),
          .right = on(right),
          .left_tree = tree_on(left),
          .right_tree = tree_on(right)};
}

std::optional<SquareCut> cut(PixelSamples& samples, const Square& square, const Corners& corners,
                             const CornerLabels& labels) {
  const auto crossed = crossed_sides(labels);
  if (!crossed) {
    return std::nullopt;
  }
  const float a = samples.area(square);
  const int steps = std::max(
      1, static_cast<int>(std::ceil(std::log2(labels.apart * a / (4.0f * samples.error())))));
  const std::array<SurfaceFit, 4> surfaces = surfaces_around(samples, square, corners, labels);
  const bool flat = std::ranges::all_of(labels.of, [&](int label) {
    return surfaces[static_cast<std::size_t>(label)].range * a <= samples.error();
  });
  const auto crossing = [&](int side) {
    const auto i = static_cast<std::size_t>(side);
    if (!samples.by_colour() && flat &&
        samples.lattice().sampler().tells_cheaply(corners[corner_turn[i]]->tree,
                                                  corners[corner_turn[(i + 1) % 4]]->tree)) {
      if (const auto cheap =
              cross_cheaply(samples, square, corners, surfaces, labels, side, steps)) {
        return std::optional(*cheap);
      }
    }
    return cross(samples, square, corners, labels, side, steps);
  };
  const auto first = crossing((*crossed)[0]);
  const auto second = first ? crossing((*crossed)[1]) : std::nullopt;
  if (!second) {
    return std::nullopt;
  }
  const auto point_on = [](int side, float at) {
    const auto i = static_cast<std::size_t>(side);
    return glm::mix(glm::vec2(corner_place[i]), glm::vec2(corner_place[(i + 1) % 4]), at);
  };
  SquareCut out{.ends = {point_on((*crossed)[0], first->at), point_on((*crossed)[1], second->at)},
                .sides = *crossed,
                .exact = std::max(first->exact, second->exact),
                .error = std::ldexp(labels.apart * a / 4.0f, -steps)};
  divide(corners, labels, *first, *second, out);
  const auto allow = [&](float error) {
    out.error = std::max(out.error, error);
    return error <= samples.error();
  };
  for (SquareCut::Part& part : out.parts) {
    part.integral = integral(part.region);
    part.surface = surfaces[static_cast<std::size_t>(part.region.label)];
    const glm::vec4 expected = part.surface.at(part.integral.centre);
    if (part.surface.plane &&
        !allow(magnitude(expected - part.integral.mean) * part.integral.area * a)) {
      return std::nullopt;
    }
  }
  const float missed = border_bulge * labels.apart * a;
  const bool known = missed <= samples.error()
                         ? allow(missed)
                         : allow(error_in_middle(samples, square, corners, labels, out));
  return known ? std::optional(out) : std::nullopt;
}

}  // namespace raycat
