#include "antialias/corner_labels.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace raycat {

CornerLabels label_corners(const Corners& corners, bool by_colour, float least, float share) {
  CornerLabels labels;
  std::array<std::array<float, 4>, 4> distances{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      distances[i][j] = distance_of(corners[i]->colour, corners[j]->colour);
      distances[j][i] = distances[i][j];
      labels.farthest = std::max(labels.farthest, distances[i][j]);
    }
  }
  by_colour = by_colour || std::ranges::all_of(corners, [&](const ColourSample* corner) {
                return corner->tree == corners[0]->tree;
              });
  for (std::size_t i = 0; i < corners.size(); ++i) {
    labels.of[i] = static_cast<int>(i);
    for (std::size_t j = 0; j < i && !by_colour; ++j) {
      if (corners[j]->tree == corners[i]->tree) {
        labels.of[i] = labels.of[j];
        break;
      }
    }
  }
  const auto apart = [&](int a, int b) {
    float distance = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < corners.size(); ++j) {
        if (labels.of[i] == a && labels.of[j] == b) {
          distance = std::max(distance, distances[i][j]);
        }
      }
    }
    return distance;
  };
  for (;;) {
    float nearest = std::max(least, share * labels.farthest);
    std::pair<int, int> join(-1, -1);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (labels.of[i] != labels.of[j]) {
          const float distance = apart(labels.of[j], labels.of[i]);
          if (distance < nearest) {
            nearest = distance;
            join = {labels.of[j], labels.of[i]};
          }
        }
      }
    }
    if (join.first < 0) {
      break;
    }
    std::ranges::replace(labels.of, join.second, join.first);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto before = labels.of.begin() + static_cast<std::ptrdiff_t>(i);
    labels.count += std::find(labels.of.begin(), before, labels.of[i]) == before ? 1 : 0;
    for (std::size_t j = 0; j < i; ++j) {
      if (labels.of[i] != labels.of[j]) {
        labels.apart = std::max(labels.apart, distances[i][j]);
      }
    }
  }
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
