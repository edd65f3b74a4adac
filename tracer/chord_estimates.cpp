#include "tracer/chord_estimates.hpp"

#include <algorithm>
#include <cmath>

namespace raycat {
namespace {

using Batch = ObjectChords::Batch;

constexpr int batches = ObjectChords::batches;

struct Mean {
  double value = 0.0;
  double variance = 0.0;
};

// Over the batches of one axis; `value` of a batch is a sum over its rays, of which each stands for
// its part of the box's face.
template <typename Value>
Mean over_face(const ObjectChords& chords, int axis, const Value& value) {
  const glm::dvec3 size = 2.0 * chords.box.half_size();
  const double face = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  std::array<double, batches> found{};
  Mean mean;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Batch& batch = chords.axes[static_cast<std::size_t>(axis)][i];
    found[i] = face * value(batch.sums) / static_cast<double>(batch.rays);
    mean.value += found[i] / batches;
  }
  for (const double one : found) {
    mean.variance += (one - mean.value) * (one - mean.value) / (batches * (batches - 1));
  }
  return mean;
}

double length_of(const ChordSums& sums, ChordsOf which) { return (sums.*which).length; }

// How much each axis counts in what all of them give whole: by its precision, but none for nearly
// everything, for an axis can seem precise because all its rays miss the same thing. And all alike
// where few rays tell: the more of them miss, the more precise they seem.
std::array<double, 3> weights(const ObjectChords& chords, ChordsOf which) {
  constexpr double doubt = 0.25;      // in mean variances
  constexpr std::uint64_t few = 256;  // in a batch
  std::array<double, 3> out{};
  double mean = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double& variance = out[static_cast<std::size_t>(axis)];
    variance = over_face(chords, axis, [&](const ChordSums& sums) {
                 return length_of(sums, which);
               }).variance;
    mean += variance / 3.0;
  }
  const bool telling = chords.axes[0][0].rays >= few;
  double sum = 0.0;
  for (double& one : out) {
    one = telling && mean > 0.0 ? mean / (one + doubt * mean) : 1.0;
    sum += one;
  }
  for (double& one : out) {
    one /= sum;
  }
  return out;
}

template <typename Value>
Estimate mean_of_axes(const ObjectChords& chords, const std::array<double, 3>& weights,
                      const Value& value) {
  std::array<Mean, 3> axes;
  double mean = 0.0;
  double within = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    axes[i] = over_face(chords, axis, value);
    mean += weights[i] * axes[i].value;
    within += weights[i] * weights[i] * axes[i].variance;
  }
  // Where the axes differ by more than their batches do, some of them miss what others see.
  double between = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    between += 0.5 * weights[i] * (axes[i].value - mean) * (axes[i].value - mean);
  }
  return {.value = mean, .error = std::sqrt(std::max(within, between))};
}

}  // namespace

Estimate volume(const ObjectChords& chords, ChordsOf which) {
  return mean_of_axes(chords, weights(chords, which),
                      [&](const ChordSums& sums) { return length_of(sums, which); });
}

// Each axis gives a part of it.
Estimate area(const ObjectChords& chords, ChordsOf which) {
  double sum = 0.0;
  double variance = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const Mean one =
        over_face(chords, axis, [&](const ChordSums& sums) { return (sums.*which).cosines; });
    sum += one.value;
    variance += one.variance;
  }
  return {.value = sum, .error = std::sqrt(variance)};
}

PointEstimate moment(const ObjectChords& chords, ChordsOf which, const glm::dvec3& point) {
  PointEstimate out;
  const glm::dvec3 shift = chords.box.center() - point;
  const std::array<double, 3> counts = weights(chords, which);
  for (int k = 0; k < 3; ++k) {
    const Estimate one = mean_of_axes(chords, counts, [&](const ChordSums& sums) {
      return (sums.*which).moment[k] + shift[k] * length_of(sums, which);
    });
    out.value[k] = one.value;
    out.error[k] = one.error;
  }
  return out;
}

}  // namespace raycat
