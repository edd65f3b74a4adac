#include "antialias/corner_labels.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace raycat {

namespace {

using Distances = std::array<std::array<float, 4>, 4>;

Distances colour_distances(const Corners& corners) {
  Distances distances{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      distances[i][j] = distance_of(corners[i]->colour, corners[j]->colour);
      distances[j][i] = distances[i][j];
    }
  }
  return distances;
}

// A label for each tree, or for each corner.
std::array<int, 4> first_labels(const Corners& corners, bool by_colour) {
  by_colour = by_colour || std::ranges::all_of(corners, [&](const ColourSample* corner) {
                return corner->tree == corners[0]->tree;
              });
  std::array<int, 4> labels{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    labels[i] = static_cast<int>(i);
    for (std::size_t j = 0; j < i && !by_colour; ++j) {
      if (corners[j]->tree == corners[i]->tree) {
        labels[i] = labels[j];
        break;
      }
    }
  }
  return labels;
}

// The greatest distance of a corner of one label and one of the other.
float apart(int a, int b, const std::array<int, 4>& labels, const Distances& distances) {
  float distance = 0.0f;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < labels.size(); ++j) {
      if (labels[i] == a && labels[j] == b) {
        distance = std::max(distance, distances[i][j]);
      }
    }
  }
  return distance;
}

// The two labels that are nearest to each other and nearer than `limit`; -1 twice if none are.
std::pair<int, int> nearest_labels(const std::array<int, 4>& labels, const Distances& distances,
                                   float limit) {
  std::pair<int, int> nearest(-1, -1);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[i] != labels[j]) {
        const float distance = apart(labels[j], labels[i], labels, distances);
        if (distance < limit) {
          limit = distance;
          nearest = {labels[j], labels[i]};
        }
      }
    }
  }
  return nearest;
}

// Sets what the labels `of` come to: `count` and `apart`.
void measure_labels(CornerLabels& labels, const Distances& distances) {
  for (std::size_t i = 0; i < labels.of.size(); ++i) {
    const auto before = labels.of.begin() + static_cast<std::ptrdiff_t>(i);
    labels.count += std::find(labels.of.begin(), before, labels.of[i]) == before ? 1 : 0;
    for (std::size_t j = 0; j < i; ++j) {
      if (labels.of[i] != labels.of[j]) {
        labels.apart = std::max(labels.apart, distances[i][j]);
      }
    }
  }
}

}  // namespace

CornerLabels label_corners(const Corners& corners, bool by_colour, float least, float share) {
  const Distances distances = colour_distances(corners);
  CornerLabels labels{.of = first_labels(corners, by_colour)};
  for (const auto& row : distances) {
    for (const float distance : row) {
      labels.farthest = std::max(labels.farthest, distance);
    }
  }
  const float limit = std::max(least, share * labels.farthest);
  for (;;) {
    const auto [kept, joined] = nearest_labels(labels.of, distances, limit);
    if (kept < 0) {
      break;
    }
    std::ranges::replace(labels.of, joined, kept);
  }
  measure_labels(labels, distances);
  return labels;
}

int label_of(const ColourSample& sample, const Corners& corners, const CornerLabels& labels,
             bool by_colour) {
  for (std::size_t i = 0; i < corners.size() && !by_colour; ++i) {
    if (corners[i]->tree == sample.tree && !corners[i]->textured) {
      return labels.of[i];
    }
  }
  if (!by_colour && !sample.textured) {
    return -1;
  }
  const auto nearest = std::ranges::min_element(corners, {}, [&](const ColourSample* corner) {
    return squared_magnitude(corner->colour - sample.colour);
  });
  return labels.of[static_cast<std::size_t>(nearest - corners.begin())];
}

}  // namespace raycat
