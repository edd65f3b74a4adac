#include "csg/solid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "csg/coincident_leaves.hpp"
#include "csg/set_bounds.hpp"
#include "geometry/line_clip.hpp"

namespace raycat {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Around where a leaf matters, in tolerances, so that a crossing left out coincides with none that
// is not.
constexpr double reach_margin = 4.0;

// How far apart crossings at one place may be by rounding, of the coordinates they are computed
// from; where a line meets two faces at their common edge, some of them are hit at a small angle.
constexpr double rounding = 0x1p-40;

// How far behind its begin `first` looks, in lengths of a group: where a group begins depends on
// the one before only while crossings follow each other within one.
constexpr double groups_behind = 16.0;

// How far along the line a crossing is moved onto a surface at most, in distances of the piece that
// is farthest from its surface: a line at a smaller angle to that than the inverse sees it as it
// is.
constexpr double farthest_shift = 1e4;

double extent_of(const Bounds& box) {
  if (box.empty()) {
    return 1.0;
  }
  const glm::dvec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
  return std::max({farthest.x, farthest.y, farthest.z});
}

double tolerance_of(const CsgTree& tree) { return coincidence_tolerance(bounded_leaves(tree)); }

CsgTree complete(CsgTree tree) {
  tree.require_complete();
  tree.shrink_to_fit();
  return tree;
}

// In what order crossings come: those at one place in the order of the leaves.
template <typename Event>
bool before(const Event& a, const Event& b) {
  return std::tie(a.t, a.leaf, a.crossing) < std::tie(b.t, b.leaf, b.crossing);
}

// For a heap with the first on top.
constexpr auto after = [](const auto& a, const auto& b) { return before(b, a); };

}  // namespace

Solid::Solid(CsgTree tree)
    : tree_(complete(std::move(tree))),
      extent_(extent_of(bounded_leaves(tree_))),
      coincident_(coincident_leaves(tree_)),
      bounds_(set_bounds(tree_).back()),
      leaves_(tree_.leaves()),
      paths_(tree_),
      index_(leaf_reach(tree_, set_bounds(tree_), reach_margin * tolerance_of(tree_))) {}

double Solid::group_length(const Ray& ray) const {
  const glm::dvec3 from = glm::abs(ray.origin);
  return rounding * (extent_ + from.x + from.y + from.z) / glm::length(ray.direction);
}

double Solid::shift(const Ray& ray) const {
  if (!coincident_.any()) {
    return 0.0;
  }
  return farthest_shift * (coincident_.farthest() / glm::length(ray.direction) + group_length(ray));
}

// Moves the leaf's crossings, from `first` on, to where the line passes through the surfaces that
// it shares with others. Where that makes the leaf end before it begins, the line misses it.
void Solid::settle(const Ray& ray, std::uint32_t leaf, std::size_t first, Scratch& scratch) const {
  Crossings& crossings = scratch.crossings_;
  bool ascending = true;
  for (std::size_t k = first; k < crossings.size(); ++k) {
    Crossing& crossing = crossings[k];
    if (const auto place = coincident_.place(leaf, crossing.piece);
        place.surface != CoincidentSurfaces::none) {
      const double t = coincident_.passage(place.surface, ray, crossing.t, crossing.entering);
      if (std::abs(t - crossing.t) <= scratch.shift_) {
        crossing.t = t;
      }
    }
    ascending = ascending && (k == first || crossings[k - 1].t <= crossing.t);
  }
  if (ascending) {
    return;
  }
  std::size_t kept = first;
  for (std::size_t k = first; k < crossings.size(); ++k) {
    if (kept > first && crossings[k].t < crossings[kept - 1].t) {
      --kept;
    } else {
      crossings[kept++] = crossings[k];
    }
  }
  crossings.resize(kept);
}

// Adds the leaf's crossings from `begin` on to the events, and sets the side it is on before.
void Solid::add_leaf(const Ray& ray, std::uint32_t leaf, double begin, Scratch& scratch) const {
  const auto first = static_cast<std::uint32_t>(scratch.crossings_.size());
  bool inside = leaves_.cross_local(leaf, ray, scratch.crossings_);
  if (coincident_.any()) {
    settle(ray, leaf, first, scratch);
  }
  for (std::uint32_t k = first; k < scratch.crossings_.size(); ++k) {
    const double t = scratch.crossings_[k].t;
    if (t < begin) {
      inside = !inside;
    } else {
      scratch.events_.push_back({.t = t, .leaf = leaf, .crossing = k});
    }
  }
  if (inside) {
    scratch.state_.toggle(leaf);
  }
}

// Passes the events of `group_` from `begin` to `end`, and adds the boundary that they make.
void Solid::pass_group(Scratch& scratch, std::size_t begin, std::size_t end) const {
  const std::span events(scratch.group_.data() + begin, end - begin);
  HeavyPaths::State& state = scratch.state_;
  const Scratch::Event* best = nullptr;
  if (events.size() == 1) {  // nearly always; responsible if anything is
    if (state.toggle(events.front().leaf)) {
      best = events.data();
    }
  } else {
    state.begin_group();
    bool changed = false;
    for (const Scratch::Event& event : events) {
      changed = state.toggle(event.leaf) != changed;
    }
    state.end_group();
    if (!changed) {
      return;
    }
    const auto rank = [&](const Scratch::Event& event) {
      const std::uint32_t face = scratch.crossings_[event.crossing].face;
      return std::tuple(paths_.subtracted(event.leaf),
                        static_cast<std::uint32_t>(tree_.leaves()[event.leaf].first_face) + face);
    };
    for (const Scratch::Event& event : events) {
      // A leaf crossed to and fro and to again is met where it goes the way it went on the whole.
      if (scratch.crossings_[event.crossing].entering == state.leaf_inside(event.leaf) &&
          state.responsible(event.leaf) && (best == nullptr || rank(event) < rank(*best))) {
        best = &event;
      }
    }
    assert(best != nullptr);
  }
  if (best == nullptr) {
    return;
  }
  const Crossing& crossing = scratch.crossings_[best->crossing];
  scratch.boundaries.push_back({.t = crossing.t,
                                .leaf = best->leaf,
                                .face = crossing.face,
                                .piece = crossing.piece,
                                .entering = state.inside(),
                                .subtracted = paths_.subtracted(best->leaf),
                                .normal = crossing.normal});
}

bool Solid::cross(const Ray& ray, Scratch& scratch) const {
  scratch.boundaries.clear();
  scratch.crossings_.clear();
  if (lone()) {
    const bool starts_inside = leaves_.cross_local(0, ray, scratch.crossings_);
    for (const Crossing& crossing : scratch.crossings_) {
      scratch.boundaries.push_back({.t = crossing.t,
                                    .face = crossing.face,
                                    .piece = crossing.piece,
                                    .entering = crossing.entering,
                                    .normal = crossing.normal});
    }
    return starts_inside;
  }
  const LineClip clip(ray);
  if (clip(bounds_).empty()) {
    return false;
  }
  scratch.events_.clear();
  scratch.shift_ = shift(ray);
  scratch.state_.start(paths_);
  // In a large tree most time goes by waiting for memory, so all that the leaves need is asked for
  // before any of it is used.
  std::vector<std::uint32_t>& met = scratch.met_;
  met.clear();
  index_.visit(ray, [&](std::uint32_t leaf) {
    leaves_.prefetch(leaf);
    paths_.prefetch(leaf);
    met.push_back(leaf);
  });
  for (const std::uint32_t leaf : met) {
    scratch.state_.prefetch(leaf);
  }
  for (const std::uint32_t leaf : met) {
    add_leaf(ray, leaf, -infinity, scratch);
  }
  std::ranges::sort(scratch.events_, before<Scratch::Event>);
  const bool starts_inside = scratch.state_.inside();

  const double length = group_length(ray);
  std::swap(scratch.group_, scratch.events_);
  const std::vector<Scratch::Event>& events = scratch.group_;
  for (std::size_t begin = 0; begin < events.size();) {
    const double last = events[begin].t + length;
    std::size_t end = begin + 1;
    while (end < events.size() && events[end].t <= last) {
      ++end;
    }
    pass_group(scratch, begin, end);
    begin = end;
  }
  return starts_inside;
}

std::optional<Boundary> Solid::first(const Ray& ray, double begin, double end,
                                     Scratch& scratch) const {
  scratch.crossings_.clear();
  scratch.wanted_ = {.begin = begin, .end = end};
  if (lone()) {
    leaves_.cross_local(0, ray, scratch.crossings_);
    scratch.passed_ = 0;
    return next_of_lone(scratch);
  }
  scratch.boundaries.clear();
  scratch.events_.clear();
  scratch.ray_ = ray;
  scratch.length_ = group_length(ray);
  scratch.shift_ = shift(ray);
  scratch.known_ = {.begin = begin - groups_behind * scratch.length_,
                    .end = end + 2.0 * scratch.length_};
  // Where a crossing may be before it is moved.
  const Interval near{.begin = scratch.known_.begin - scratch.shift_,
                      .end = scratch.known_.end + scratch.shift_};
  if (LineClip(ray)(bounds_, near).empty()) {
    return std::nullopt;
  }
  scratch.state_.start(paths_);
  scratch.search_.start(index_, ray, near);
  return next_of_tree(scratch);
}

std::optional<Boundary> Solid::next(Scratch& scratch) const {
  return lone() ? next_of_lone(scratch) : next_of_tree(scratch);
}

std::optional<Boundary> Solid::next_of_lone(Scratch& scratch) const {
  while (scratch.passed_ < scratch.crossings_.size()) {
    const Crossing& crossing = scratch.crossings_[scratch.passed_++];
    if (crossing.t > scratch.wanted_.begin && crossing.t < scratch.wanted_.end) {
      return Boundary{.t = crossing.t,
                      .face = crossing.face,
                      .piece = crossing.piece,
                      .entering = crossing.entering,
                      .normal = crossing.normal};
    }
  }
  return std::nullopt;
}

std::optional<Boundary> Solid::next_of_tree(Scratch& scratch) const {
  // Leaves are met in the order in which the line comes to their boxes, each no sooner than the
  // events before it are passed: until then it is outside, or does not matter.
  std::vector<Scratch::Event>& events = scratch.events_;
  const double length = scratch.length_;
  for (;;) {
    const auto needed = [&] {
      return events.empty() ? infinity : events.front().t + 2.0 * length + scratch.shift_;
    };
    while (const std::optional<std::uint32_t> leaf = scratch.search_.next(needed())) {
      const std::size_t known = events.size();
      add_leaf(scratch.ray_, *leaf, scratch.known_.begin, scratch);
      for (std::size_t i = known; i < events.size(); ++i) {
        std::push_heap(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(i) + 1, after);
      }
    }
    if (events.empty() || events.front().t > scratch.known_.end) {
      return std::nullopt;
    }
    scratch.group_.clear();
    const double last = events.front().t + length;
    while (!events.empty() && events.front().t <= last) {
      std::ranges::pop_heap(events, after);
      scratch.group_.push_back(events.back());
      events.pop_back();
    }
    scratch.boundaries.clear();
    pass_group(scratch, 0, scratch.group_.size());
    if (!scratch.boundaries.empty() && scratch.boundaries.back().t > scratch.wanted_.begin) {
      const Boundary& found = scratch.boundaries.back();
      return found.t < scratch.wanted_.end ? std::optional(found) : std::nullopt;
    }
  }
}

glm::dvec3 Solid::normal(const Boundary& boundary) const noexcept {
  const glm::dvec3 outward =
      tree_.leaves()[boundary.leaf].shape.transform().normal(boundary.normal);
  return boundary.subtracted ? -outward : outward;
}

}  // namespace raycat
