#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <glm/vec2.hpp>

#include "antialias/adaptive.hpp"
#include "antialias/over_lattice.hpp"

namespace raycat {

/// A square's corners in turn, as numbers in `Corners`, and where they are. Side `i` of a square is
/// from corner `i` to the next: above, right, below, left.
constexpr std::array<std::size_t, 4> corner_turn{0, 1, 3, 2};
constexpr std::array<glm::ivec2, 4> corner_place{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// The lattice as whoever antialiases a pixel sees it: what may be off, and whether samples were
/// needed that were not there.
class PixelSamples {
 public:
  /// Keeps references.
  PixelSamples(SampleLattice& lattice, const AdaptiveSettings& settings, int worker)
      : lattice_(lattice), settings_(settings), worker_(worker) {}

  /// Another pixel, which may be off by `error`.
  void start(float error) {
    error_ = error;
    refined_ = false;
  }

  SampleLattice& lattice() const noexcept { return lattice_; }
  bool by_colour() const noexcept { return !settings_.categories; }
  const AdaptiveConstants& constants() const noexcept { return settings_.constants; }
  float error() const noexcept { return error_; }
  bool refined() const noexcept { return refined_; }

  Corners corners(const Square& square) { return square.corners(lattice_, worker_); }

  /// The sample at a point of the lattice; `fresh` is set if it was not there.
  const ColourSample& sample(const glm::ivec2& point, bool* fresh = nullptr) {
    bool is_fresh = false;
    const ColourSample& sample = lattice_.at(point, worker_, &is_fresh);
    refined_ = refined_ || is_fresh;
    if (fresh != nullptr) {
      *fresh = is_fresh;
    }
    return sample;
  }

  /// As `SampleLattice::side`.
  std::optional<TreeId> side(const glm::ivec2& point, TreeId a, TreeId b) {
    refined_ = true;
    return lattice_.side(point, a, b, worker_);
  }

  /// Of a square, in pixels.
  float side_length(const Square& square) const {
    return static_cast<float>(square.size) / static_cast<float>(lattice_.units());
  }
  float area(const Square& square) const { return side_length(square) * side_length(square); }

  bool is_pixel(const Square& square) const { return square.size == lattice_.units(); }

  /// Calls `visit(place, sample)` for those of the sixteen samples of a square and around it that
  /// are there; places are in sides of the square, from its first corner.
  template <typename Visit>
  void for_each_around(const Square& square, const Visit& visit) const {
    for (int j = -1; j <= 2; ++j) {
      for (int i = -1; i <= 2; ++i) {
        const glm::ivec2 place(i, j);
        if (const ColourSample* sample = lattice_.find(square.at + square.size * place)) {
          visit(place, *sample);
        }
      }
    }
  }

 private:
  SampleLattice& lattice_;
  const AdaptiveSettings& settings_;
  int worker_;
  float error_ = 0.0f;
  bool refined_ = false;
};

}  // namespace raycat
