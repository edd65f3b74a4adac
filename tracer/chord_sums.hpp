#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/leaf_bvh.hpp"
#include "csg/solid.hpp"
#include "tracer/object_volumes.hpp"

namespace raycat {

/// What the chords of lines through a solid add up to.
struct Chords {
  double length = 0.0;
  glm::dvec3 moment{0.0};  ///< of the length, about the centre of the solid's box
  double cosines = 0.0;    ///< of the normals with the lines, where these cross the surface

  Chords& operator+=(const Chords& other) {
    length += other.length;
    moment += other.moment;
    cosines += other.cosines;
    return *this;
  }
};

/// The points of a surface that are farthest out: along -x, +x, -y, +y, -z and +z.
struct Extremes {
  std::array<glm::dvec3, 6> points;
  bool empty = true;

  void include(const glm::dvec3& point);
  void include(const Extremes& other);
};

/// The sums of some lines.
struct ChordSums {
  Chords own;     ///< of the object by itself
  Chords united;  ///< of what it adds to the union of all objects
  Extremes extremes;
};

/// Casts lines through the objects of a scene, each within its box.
class ChordCaster {
 public:
  struct Scratch {
    Solid::Scratch solid;
    std::vector<Boundary> chords;
    struct Event {
      double t;
      std::uint32_t object;
      bool entering;
      double cosine;
    };
    std::vector<Event> events;
    std::vector<std::uint32_t> neighbours;
  };

  /// Refers to `objects`.
  explicit ChordCaster(const std::vector<ObjectVolume>& objects);

  /// Adds what the line through `across`, in units of the box's sides, along `axis` meets. The
  /// object must have a solid that is not empty.
  void cast(std::uint32_t object, int axis, const glm::dvec2& across, Scratch& scratch,
            ChordSums& sums) const;

 private:
  bool add_neighbours(std::uint32_t object, const Ray& ray, Scratch& scratch) const;
  void unite(std::uint32_t object, const Ray& ray, const Chords& own, Scratch& scratch,
             Chords& united) const;

  const std::vector<ObjectVolume>& objects_;
  LeafBvh boxes_;
};

}  // namespace raycat
