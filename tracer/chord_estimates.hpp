#pragma once

#include <array>
#include <cstdint>

#include "geometry/bounds.hpp"
#include "tracer/chord_sums.hpp"
#include "tracer/measure.hpp"

namespace raycat {

/// The sums of the rays through one object, in batches for each axis that know nothing of each
/// other.
struct ObjectChords {
  static constexpr int batches = 8;

  struct Batch {
    ChordSums sums;
    std::uint64_t rays = 0;  ///< at least one
  };
  using Axis = std::array<Batch, batches>;

  Bounds box;  ///< that the rays go through
  std::array<Axis, 3> axes;
};

/// Which sums of `ChordSums` are meant.
using ChordsOf = Chords ChordSums::*;

Estimate volume(const ObjectChords& chords, ChordsOf which);
Estimate area(const ObjectChords& chords, ChordsOf which);

/// The integral of the volume's way from `point`.
PointEstimate moment(const ObjectChords& chords, ChordsOf which, const glm::dvec3& point);

}  // namespace raycat
