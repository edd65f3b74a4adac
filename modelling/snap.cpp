#include "modelling/snap.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace raycat {

void snap(std::span<glm::dvec3> positions, double tolerance) {
  std::vector<double> sorted(positions.size());
  std::vector<double> kept;  // of each cluster, the first value and what all become
  std::vector<double> first;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      sorted[i] = positions[i][axis];
    }
    std::ranges::sort(sorted);
    kept.clear();
    first.clear();
    for (std::size_t i = 0; i < sorted.size();) {
      const double begin = sorted[i];
      double best = begin;
      std::size_t most = 0;
      while (i < sorted.size() && sorted[i] <= begin + tolerance) {
        const std::size_t equal = i;
        while (i < sorted.size() && sorted[i] == sorted[equal]) {
          ++i;
        }
        if (i - equal > most) {
          most = i - equal;
          best = sorted[equal];
        }
      }
      first.push_back(begin);
      kept.push_back(best);
    }
    for (glm::dvec3& position : positions) {
      const auto after = std::ranges::upper_bound(first, position[axis]);
      position[axis] = kept[static_cast<std::size_t>(after - first.begin()) - 1];
    }
  }
}

}  // namespace raycat
