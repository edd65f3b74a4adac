#pragma once

#include <algorithm>
#include <array>

#include "antialias/antialias.hpp"
#include "antialias/colour_distance.hpp"
#include "threads/parallel.hpp"

namespace raycat {

/// The four corners of a square, left to right, top to bottom.
using Corners = std::array<const ColourSample*, 4>;

inline glm::vec4 mean_of(const Corners& corners) {
  return 0.25f *
         ((corners[0]->colour + corners[1]->colour) + (corners[2]->colour + corners[3]->colour));
}

/// The greatest distance of two corners' colours.
inline float farthest(const Corners& corners) {
  float distance = 0.0f;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      distance = std::max(distance, distance_of(corners[i]->colour, corners[j]->colour));
    }
  }
  return distance;
}

/// A square on the lattice.
struct Square {
  glm::ivec2 at{0};  ///< its top left corner, in lattice units
  int size = 0;      ///< in lattice units

  Corners corners(SampleLattice& lattice, int worker) const {
    return {&lattice.at(at, worker), &lattice.at({at.x + size, at.y}, worker),
            &lattice.at({at.x, at.y + size}, worker),
            &lattice.at({at.x + size, at.y + size}, worker)};
  }
};

inline Square pixel_square(const SampleLattice& lattice, int x, int y) {
  return {.at = glm::ivec2(x, y) * lattice.units(), .size = lattice.units()};
}

/// Calls `row(y, worker)` for all rows, first the even and then the odd ones, so that no two that
/// touch are worked on at once and the order in which neighbours meet is always the same.
template <typename Row>
void each_row_apart(int height, int threads, const Row& row) {
  for (int parity = 0; parity < 2; ++parity) {
    parallel_rows((height + 1 - parity) / 2, threads,
                  [&](int i, int worker) { row(2 * i + parity, worker); });
  }
}

}  // namespace raycat
