#include "reference/solid_passages.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "geometry/mesh.hpp"
#include "reference/coincidence.hpp"
#include "reference/shape_passages.hpp"

namespace raycat::reference {

struct SolidPassages::Event {
  Real t;
  Vec normal;  // out of the leaf
  std::uint32_t leaf;
  std::uint32_t face;
  bool entering;  // into the leaf
};

SolidPassages::SolidPassages(const CsgTree& tree) : tree_(tree) {
  Bounds all;
  for (const CsgLeaf& leaf : tree.leaves()) {
    leaves_.push_back({.place = Place(leaf.shape.transform())});
    if (leaf.shape.bounds().finite()) {
      all.include(leaf.shape.bounds());
    }
    if (const auto* mesh = std::get_if<MeshShape>(&leaf.shape.shape())) {
      Leaf& made = leaves_.back();
      for (const glm::dvec3& p : (*mesh)->mesh().positions) {
        made.middle += Vec(p) / static_cast<Real>((*mesh)->mesh().positions.size());
      }
      for (const glm::dvec3& p : (*mesh)->mesh().positions) {
        made.radius = std::max(made.radius, glm::length(Vec(p) - made.middle) * 1.000001L);
      }
    }
  }
  const bool lone = tree.nodes().size() == 1;
  distance_ = lone || all.empty() ? 0.0L : coincident * glm::length(Vec(all.half_size()));
  for (std::size_t node = 0; node < tree.nodes().size(); ++node) {
    if (tree.nodes()[node].leaf == CsgTree::no_leaf) {
      continue;
    }
    Leaf& leaf = leaves_[tree.nodes()[node].leaf];
    leaf.node = node;
    for (std::size_t up = node; up != CsgTree::no_parent; up = tree.nodes()[up].parent) {
      leaf.subtracted = leaf.subtracted != tree.nodes()[up].subtracted;
    }
  }
}

bool SolidPassages::add_events(const Line& line, std::uint32_t leaf,
                               std::vector<Event>& events) const {
  const Leaf& placed = leaves_[leaf];
  const Shape& shape = tree_.leaves()[leaf].shape.shape();
  const Line local = placed.place.to_local(line);
  if (placed.radius >= 0.0L) {
    const Vec off = glm::cross(placed.middle - local.origin, glm::normalize(local.direction));
    if (glm::length(off) > placed.radius) {
      return false;
    }
  }
  const std::vector<Passage> met = passages(shape, local);
  for (const Passage& passage : met) {
    events.push_back({.t = passage.t,
                      .normal = placed.place.normal(passage.normal),
                      .leaf = leaf,
                      .face = passage.face,
                      .entering = glm::dot(passage.normal, local.direction) < 0.0L});
  }
  return met.empty() && contains(shape, local.origin);
}

// A point is in a leaf if the last passage before it leads in, or else the first one after it out.
SolidPassages::Sides SolidPassages::sides(const std::vector<Event>& events, Sides in_leaf,
                                          Real t) const {
  std::vector<bool> known(leaves_.size());
  for (const Event& event : events) {
    if (event.t < t) {
      in_leaf[event.leaf] = event.entering;
      known[event.leaf] = true;
    } else if (!known[event.leaf]) {
      in_leaf[event.leaf] = !event.entering;
      known[event.leaf] = true;
    }
  }
  Sides inside(tree_.nodes().size());
  for (std::size_t i = 0; i < inside.size(); ++i) {  // what an operation starts from
    inside[i] = tree_.nodes()[i].leaf == CsgTree::no_leaf &&
                tree_.nodes()[i].operation != Operation::set_union;
  }
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const CsgTree::Node& node = tree_.nodes()[i];
    if (node.leaf != CsgTree::no_leaf) {
      inside[i] = in_leaf[node.leaf];
    }
    if (node.parent == CsgTree::no_parent) {
      continue;
    }
    switch (tree_.nodes()[node.parent].operation) {
      case Operation::set_union:
        inside[node.parent] = inside[node.parent] || inside[i];
        break;
      case Operation::intersection:
        inside[node.parent] = inside[node.parent] && inside[i];
        break;
      case Operation::difference:
        inside[node.parent] = inside[node.parent] && inside[i] != node.subtracted;
        break;
    }
  }
  return inside;
}

bool SolidPassages::responsible(std::size_t node, const Sides& before, const Sides& after) const {
  for (; node != CsgTree::no_parent; node = tree_.nodes()[node].parent) {
    if (before[node] == after[node]) {
      return false;
    }
  }
  return true;
}

std::vector<Boundary> SolidPassages::operator()(const Line& line) const {
  std::vector<Event> events;
  Sides throughout(leaves_.size());
  for (std::uint32_t leaf = 0; leaf < leaves_.size(); ++leaf) {
    throughout[leaf] = add_events(line, leaf, events);
  }
  std::ranges::sort(events, {}, &Event::t);
  std::vector<Boundary> result;
  for (std::size_t begin = 0, end = 0; begin < events.size(); begin = end) {
    const Event& first = events[begin];
    for (end = begin + 1; end < events.size(); ++end) {
      if (!in_one_surface(line.direction, first.t, first.normal, events[end].t, events[end].normal,
                          distance_)) {
        break;
      }
    }
    const Real earlier = begin == 0 ? first.t - 1.0L : (events[begin - 1].t + first.t) / 2.0L;
    const Real later = end == events.size() ? events[end - 1].t + 1.0L
                                            : (events[end - 1].t + events[end].t) / 2.0L;
    const Sides before = sides(events, throughout, earlier);
    const Sides after = sides(events, throughout, later);
    if (before.back() == after.back()) {
      continue;
    }
    const auto rank = [&](const Event& event) {
      return std::tuple(
          leaves_[event.leaf].subtracted,
          static_cast<std::uint32_t>(tree_.leaves()[event.leaf].first_face) + event.face);
    };
    const Event* chosen = nullptr;
    for (std::size_t i = begin; i < end; ++i) {
      const Event& event = events[i];
      if (responsible(leaves_[event.leaf].node, before, after) &&
          (chosen == nullptr || rank(event) < rank(*chosen))) {
        chosen = &event;
      }
    }
    if (chosen != nullptr) {
      const bool flipped = leaves_[chosen->leaf].subtracted;
      result.push_back({.t = chosen->t,
                        .normal = flipped ? -chosen->normal : chosen->normal,
                        .entering = after.back(),
                        .leaf = chosen->leaf,
                        .face = chosen->face});
    }
  }
  return result;
}

}  // namespace raycat::reference
