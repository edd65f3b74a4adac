#include "tracer/chord_sums.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

namespace raycat {
namespace {

std::vector<Bounds> boxes(const std::vector<ObjectVolume>& objects) {
  std::vector<Bounds> out(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].solid != nullptr) {
      out[i] = objects[i].solid->bounds();
    }
  }
  return out;
}

// The chord from `begin` to `end` of a ray along `axis` whose origin is `from`, in the box's frame.
void add_chord(double begin, double end, const glm::dvec3& from, int axis, Chords& to) {
  const double length = end - begin;
  to.length += length;
  glm::dvec3 middle = from;
  middle[axis] = 0.5 * (begin + end);
  to.moment += length * middle;
}

// Surfaces that are this close are one.
double surface_tolerance(const Bounds& box) {
  return 1e-9 * glm::length(box.half_size()) +
         1e-15 * glm::length(glm::max(glm::abs(box.min), glm::abs(box.max)));
}

using Event = ChordCaster::Scratch::Event;

// Of events at one place, where the line enters the union or leaves it, that of the first object
// that the union's surface is a surface of, which has it.
const Event* owner(std::span<const Event> events, bool entering) {
  const Event* first = nullptr;
  for (const Event& event : events) {
    if (event.entering == entering && (first == nullptr || event.object < first->object)) {
      first = &event;
    }
  }
  return first;
}

}  // namespace

void Extremes::include(const glm::dvec3& point) {
  for (int side = 0; side < 6; ++side) {
    glm::dvec3& best = points[static_cast<std::size_t>(side)];
    const int axis = side / 2;
    const bool farther = side % 2 == 0 ? point[axis] < best[axis] : point[axis] > best[axis];
    if (empty || farther) {
      best = point;
    }
  }
  empty = false;
}

void Extremes::include(const Extremes& other) {
  if (!other.empty) {
    for (const glm::dvec3& point : other.points) {
      include(point);
    }
  }
}

ChordCaster::ChordCaster(const std::vector<ObjectVolume>& objects)
    : objects_(objects), boxes_(boxes(objects)) {}

void ChordCaster::cast(std::uint32_t object, int axis, const glm::dvec2& across, Scratch& scratch,
                       ChordSums& sums) const {
  const Solid& solid = *objects_[object].solid;
  const Bounds& box = solid.bounds();
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  // From the middle of the box, so that t loses nothing where the box is far away.
  Ray ray{.origin = box.center(), .direction = glm::dvec3(0.0)};
  glm::dvec3 from(0.0);
  from[u] = (2.0 * across.x - 1.0) * box.half_size()[u];
  from[v] = (2.0 * across.y - 1.0) * box.half_size()[v];
  ray.origin += from;
  ray.direction[axis] = 1.0;
  solid.cross(ray, scratch.solid);
  const std::vector<Boundary>& boundaries = scratch.solid.boundaries;
  if (boundaries.empty()) {
    return;
  }
  Chords own;
  for (std::size_t i = 0; i + 1 < boundaries.size(); i += 2) {
    add_chord(boundaries[i].t, boundaries[i + 1].t, from, axis, own);
  }
  scratch.events.clear();
  for (const Boundary& boundary : boundaries) {
    const double cosine = std::abs(solid.normal(boundary)[axis]);
    own.cosines += cosine;
    scratch.events.push_back(
        {.t = boundary.t, .object = object, .entering = boundary.entering, .cosine = cosine});
  }
  sums.own += own;
  sums.extremes.include(ray.at(boundaries.front().t));
  sums.extremes.include(ray.at(boundaries.back().t));
  unite(object, ray, own, scratch, sums.united);
}

// Adds what the line crosses of others to the events. Whether there is any.
bool ChordCaster::add_neighbours(std::uint32_t object, const Ray& ray, Scratch& scratch) const {
  scratch.neighbours.clear();
  const Bounds& own_box = objects_[object].solid->bounds();
  boxes_.visit(ray, [&](std::uint32_t other) {
    if (other != object && !intersection(own_box, objects_[other].solid->bounds()).empty()) {
      scratch.neighbours.push_back(other);
    }
  });
  const std::size_t alone = scratch.events.size();
  for (const std::uint32_t other : scratch.neighbours) {
    objects_[other].solid->cross(ray, scratch.solid);
    for (const Boundary& boundary : scratch.solid.boundaries) {
      scratch.events.push_back({.t = boundary.t, .object = other, .entering = boundary.entering});
    }
  }
  return scratch.events.size() > alone;
}

// Of the union an object has what no earlier object has, and of its surface what is the union's.
void ChordCaster::unite(std::uint32_t object, const Ray& ray, const Chords& own, Scratch& scratch,
                        Chords& united) const {
  if (!add_neighbours(object, ray, scratch)) {
    united += own;
    return;
  }
  std::vector<Event>& events = scratch.events;
  std::ranges::sort(events, [](const Event& a, const Event& b) {
    return std::tie(a.t, a.object, a.entering) < std::tie(b.t, b.object, b.entering);
  });
  const Bounds& box = objects_[object].solid->bounds();
  int axis = 0;
  while (ray.direction[axis] == 0.0) {
    ++axis;
  }
  const glm::dvec3 from = ray.origin - box.center();
  const double tolerance = surface_tolerance(box);
  int within = 0;   // of how many objects the line is inside
  int earlier = 0;  // and of how many that come before this one
  bool inside = false;
  double begin = 0.0;
  for (std::size_t first = 0; first < events.size();) {
    const bool was_within = within > 0;
    std::size_t end = first;
    for (; end < events.size() && events[end].t <= events[first].t + tolerance; ++end) {
      const Event& event = events[end];
      if (inside && earlier == 0) {
        add_chord(begin, event.t, from, axis, united);
      }
      begin = event.t;
      const int change = event.entering ? 1 : -1;
      within += change;
      if (event.object == object) {
        inside = event.entering;
      } else if (event.object < object) {
        earlier += change;
      }
    }
    if (was_within != (within > 0)) {
      const Event* const has = owner(std::span(events).subspan(first, end - first), within > 0);
      if (has != nullptr && has->object == object) {
        united.cosines += has->cosine;
      }
    }
    first = end;
  }
}

}  // namespace raycat
