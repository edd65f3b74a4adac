#include "tracer/measure.hpp"

#include <algorithm>
#include <cmath>

#include <glm/exponential.hpp>

#include "threads/parallel.hpp"
#include "tracer/chord_estimates.hpp"
#include "tracer/extreme_search.hpp"
#include "tracer/object_volumes.hpp"
#include "tracer/scrambled_points.hpp"

namespace raycat {
namespace {

constexpr std::uint64_t batches = ObjectChords::batches;
constexpr std::uint64_t parts = 3 * batches;  // of the rays of an object

double size_of(const Bounds& box) {
  const glm::dvec3 half = box.half_size();
  return half.x * half.y * half.z;
}

// The part of `rays` of the i-th of n.
std::uint64_t share(std::uint64_t rays, std::uint64_t i, std::uint64_t n) {
  return rays / n + (i < rays % n ? 1 : 0);
}

// A solid that is cast rays at.
struct Target {
  std::uint32_t object = 0;
  std::uint64_t rays = 0;
  ObjectChords chords;
  Bounds bounds;
  glm::dvec3 min_error{0.0};
  glm::dvec3 max_error{0.0};
};

// Half of the rays go to all objects alike, half by the size of their boxes: the large ones make up
// most of the total, and of its error.
std::vector<Target> targets(const std::vector<ObjectVolume>& objects, std::uint64_t rays) {
  std::vector<Target> out;
  double all = 0.0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].solid != nullptr && !objects[i].solid->bounds().empty()) {
      const Bounds& box = objects[i].solid->bounds();
      out.push_back({.object = static_cast<std::uint32_t>(i), .chords{.box = box}});
      all += size_of(box);
    }
  }
  double before = 0.0;
  std::uint64_t given = 0;
  for (Target& target : out) {
    const double alike = 1.0 / static_cast<double>(out.size());
    before += 0.5 * alike + 0.5 * (all > 0.0 ? size_of(target.chords.box) / all : alike);
    const auto now = static_cast<std::uint64_t>(std::llround(before * static_cast<double>(rays)));
    target.rays = std::max(now - given, parts);
    given = now;
  }
  return out;
}

// One batch of one axis.
void cast(const ChordCaster& caster, Target& target, std::uint64_t part,
          ChordCaster::Scratch& scratch) {
  const std::uint64_t axis = part % 3;
  ObjectChords::Batch& batch = target.chords.axes[axis][part / 3];
  batch.rays = share(target.rays, part, parts);
  const ScrambledPoints points(parts * target.object + part);
  for (std::uint32_t i = 0; i < batch.rays; ++i) {
    caster.cast(target.object, static_cast<int>(axis), points(i), scratch, batch.sums);
  }
}

// From what each half of the rays has found.
void find_bounds(const Solid& solid, Target& target, Solid::Scratch& scratch) {
  const double spacing = 1.0 / std::sqrt(static_cast<double>(target.rays) / 3.0);
  Bounds found[2];
  for (std::size_t half = 0; half < 2; ++half) {
    Extremes extremes;
    for (const ObjectChords::Axis& axis : target.chords.axes) {
      for (std::size_t i = half; i < axis.size(); i += 2) {
        extremes.include(axis[i].sums.extremes);
      }
    }
    found[half] = farthest(solid, extremes, spacing, target.rays, scratch);
    target.bounds.include(found[half]);
  }
  if (!target.bounds.empty()) {
    // A half that has found nothing tells nothing.
    const bool both = !found[0].empty() && !found[1].empty();
    target.min_error =
        both ? glm::abs(found[0].min - found[1].min) : 2.0 * target.bounds.half_size();
    target.max_error = both ? glm::abs(found[0].max - found[1].max) : target.min_error;
  }
}

Measurement of_object(const Target& target) {
  const ObjectChords& chords = target.chords;
  Measurement out{.volume = volume(chords, &ChordSums::own),
                  .area = area(chords, &ChordSums::own),
                  .bounds = target.bounds,
                  .bounds_min_error = target.min_error,
                  .bounds_max_error = target.max_error};
  if (const double size = out.volume->value; size > 0.0) {
    const glm::dvec3 middle = chords.box.center();
    const glm::dvec3 centroid = middle + moment(chords, &ChordSums::own, middle).value / size;
    out.centroid = {.value = centroid,
                    .error = moment(chords, &ChordSums::own, centroid).error / size};
  }
  return out;
}

Measurement of_nothing(const ObjectVolume& object) {
  Measurement out{.bounds = object.open_bounds, .problem = object.problem};
  if (object.problem.empty()) {
    out.volume = Estimate{};
  }
  if (object.problem.empty() || !object.open_bounds.empty()) {
    out.area = Estimate{.value = object.open_area};
  }
  return out;
}

// Adds an object's bounds, and its errors where it reaches farthest.
void include(const Measurement& object, Measurement& total) {
  if (object.bounds.empty()) {
    return;
  }
  for (int k = 0; k < 3; ++k) {
    if (object.bounds.min[k] < total.bounds.min[k]) {
      total.bounds_min_error[k] = object.bounds_min_error[k];
    }
    if (object.bounds.max[k] > total.bounds.max[k]) {
      total.bounds_max_error[k] = object.bounds_max_error[k];
    }
  }
  total.bounds.include(object.bounds);
}

void add(const Estimate& part, Estimate& sum) {
  sum.value += part.value;
  sum.error = std::hypot(sum.error, part.error);
}

Measurement of_all(const std::vector<Target>& targets, const std::vector<Measurement>& objects) {
  Measurement total{.volume = Estimate{}, .area = Estimate{}};
  for (const Measurement& object : objects) {
    include(object, total);
    if (!object.volume && object.area) {
      add(*object.area, *total.area);
    }
  }
  for (const Target& target : targets) {
    add(volume(target.chords, &ChordSums::united), *total.volume);
    add(area(target.chords, &ChordSums::united), *total.area);
  }
  const double size = total.volume->value;
  if (size > 0.0) {
    const auto sum = [&](const glm::dvec3& point) {
      PointEstimate all;
      for (const Target& target : targets) {
        const PointEstimate one = moment(target.chords, &ChordSums::united, point);
        all.value += one.value;
        all.error = glm::sqrt(all.error * all.error + one.error * one.error);
      }
      return all;
    };
    const glm::dvec3 middle = total.bounds.center();
    const glm::dvec3 centroid = middle + sum(middle).value / size;
    total.centroid = {.value = centroid, .error = sum(centroid).error / size};
  }
  return total;
}

}  // namespace

SceneMeasurement measure(const Scene& scene, std::uint64_t rays, int threads) {
  const std::vector<ObjectVolume> objects = object_volumes(scene);
  const ChordCaster caster(objects);
  std::vector<Target> all = targets(objects, rays);
  std::vector<ChordCaster::Scratch> scratch(static_cast<std::size_t>(threads));
  parallel_rows(static_cast<int>(all.size() * parts), threads, [&](int row, int worker) {
    const auto i = static_cast<std::uint64_t>(row);
    cast(caster, all[i / parts], i % parts, scratch[static_cast<std::size_t>(worker)]);
  });
  parallel_rows(static_cast<int>(all.size()), threads, [&](int row, int worker) {
    Target& target = all[static_cast<std::size_t>(row)];
    find_bounds(*objects[target.object].solid, target,
                scratch[static_cast<std::size_t>(worker)].solid);
  });

  SceneMeasurement out;
  for (const ObjectVolume& object : objects) {
    out.objects.push_back(of_nothing(object));
  }
  for (const Target& target : all) {
    out.objects[target.object] = of_object(target);
    out.rays += target.rays;
  }
  out.total = of_all(all, out.objects);
  return out;
}

}  // namespace raycat
