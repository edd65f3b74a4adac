#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tracer/scene.hpp"

namespace raycat {

/// A number found by sampling, and its standard error.
struct Estimate {
  double value = 0.0;
  double error = 0.0;
};

/// A point found by sampling, and the standard errors of its coordinates.
struct PointEstimate {
  glm::dvec3 value{0.0};
  glm::dvec3 error{0.0};
};

/// What an object comes to. Volumes, areas and the centroid are unbiased but for the centroid's
/// ratio.
struct Measurement {
  std::optional<Estimate> volume;         ///< none if the object encloses no finite volume
  std::optional<Estimate> area;           ///< none if the object is unbounded
  std::optional<PointEstimate> centroid;  ///< of the volume; none if that is none or zero
  Bounds bounds;                          ///< empty if the object is, or is unbounded
  /// How far apart the bounds are that each half of the rays finds. What all rays miss is not told.
  glm::dvec3 bounds_min_error{0.0};
  glm::dvec3 bounds_max_error{0.0};
  std::string problem;  ///< why there is no volume, on one line
};

struct SceneMeasurement {
  /// Of all solids united, and of the areas and bounds of open meshes as they are. Unbounded
  /// objects are left out.
  Measurement total;
  std::vector<Measurement> objects;  ///< by `ObjectId`
  std::uint64_t rays = 0;            ///< cast for volumes and areas
};

/// 2^12 for each of the 24 batches of one object, since 2^k points of a batch's sequence are spread
/// most evenly.
inline constexpr std::uint64_t default_measure_rays = 24 * 4096;

/// Measures by rays along the three axes, `rays` of them, shared out among the objects, or the 24
/// an object that the errors need. Depends on nothing else: not on the number of threads.
///
/// A volume is the sum of the chords of the lines, for each axis; an area that of 1 / |cosine| of
/// the normal and the line, each crossing weighted with the cosine's square: over the three axes
/// these add up to 1. The rays of an axis come in 8 batches, each a low-discrepancy sequence
/// scrambled in its own way, and how the batches differ gives the errors.
SceneMeasurement measure(const Scene& scene, std::uint64_t rays, int threads);

}  // namespace raycat
