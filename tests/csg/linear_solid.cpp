#include "tests/csg/linear_solid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "csg/coincident_leaves.hpp"

namespace raycat {
namespace {

// As in `Solid`.
constexpr double rounding = 0x1p-40;
constexpr double farthest_shift = 1e4;

}  // namespace

LinearSolid::LinearSolid(CsgTree tree) : tree_(std::move(tree)) {
  tree_.require_complete();

  const auto nodes = tree_.nodes();
  gates_.resize(nodes.size());
  leaf_node_.resize(tree_.leaves().size());
  std::vector<std::uint32_t> operands(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    gates_[i].parent = nodes[i].parent;
    gates_[i].negated = nodes[i].subtracted;
    if (nodes[i].parent != CsgTree::no_parent) {
      ++operands[nodes[i].parent];
    }
    if (nodes[i].leaf != CsgTree::no_leaf) {
      leaf_node_[nodes[i].leaf] = static_cast<std::uint32_t>(i);
    } else if (nodes[i].operation != Operation::set_union) {
      gates_[i].threshold = operands[i];
    }
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Gate& gate = gates_[i];
    const bool above = gate.parent != CsgTree::no_parent && gates_[gate.parent].subtracted;
    gates_[i].subtracted = above != gate.negated;
  }
  true_inputs_.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Gate& gate = gates_[i];
    const bool value = true_inputs_[i] >= gate.threshold;
    if (gate.parent != CsgTree::no_parent && value != gate.negated) {
      ++true_inputs_[gate.parent];
    }
  }

  const Bounds all = bounded_leaves(tree_);
  if (!all.empty()) {
    const glm::dvec3 farthest = glm::max(glm::abs(all.min), glm::abs(all.max));
    extent_ = std::max({farthest.x, farthest.y, farthest.z});
  }
  coincident_ = coincident_leaves(tree_);
}

bool LinearSolid::inside(const Scratch& scratch) const {
  return scratch.true_inputs_.back() >= gates_.back().threshold;
}

// Changes the side the line is on of one leaf, and of every node above that follows. Returns
// whether the root did.
bool LinearSolid::toggle(std::uint32_t leaf, Scratch& scratch) const {
  std::uint32_t node = leaf_node_[leaf];
  bool value = scratch.true_inputs_[node] == 0;
  scratch.true_inputs_[node] = value ? 1 : 0;
  for (;;) {
    scratch.changed_[node] ^= 1;
    scratch.touched_.push_back(node);
    const Gate& gate = gates_[node];
    if (gate.parent == CsgTree::no_parent) {
      return true;
    }
    const std::uint32_t threshold = gates_[gate.parent].threshold;
    std::uint32_t& inputs = scratch.true_inputs_[gate.parent];
    const bool before = inputs >= threshold;
    inputs = value != gate.negated ? inputs + 1 : inputs - 1;
    const bool after = inputs >= threshold;
    if (before == after) {
      return false;
    }
    node = gate.parent;
    value = after;
  }
}

double LinearSolid::group_size(const Ray& ray) const {
  return rounding * (extent_ + glm::length(ray.origin));
}

void LinearSolid::gather(const Ray& ray, Scratch& scratch) const {
  const auto leaves = tree_.leaves();
  for (std::uint32_t i = 0; i < leaves.size(); ++i) {
    const PlacedShape& shape = leaves[i].shape;
    const auto first = static_cast<std::uint32_t>(scratch.crossings_.size());
    if (shape.cross_local(ray, scratch.crossings_)) {
      toggle(i, scratch);
    }
    for (std::uint32_t k = first; k < scratch.crossings_.size(); ++k) {
      Crossing& crossing = scratch.crossings_[k];
      const auto place = coincident_.place(i, crossing.piece);
      if (place.surface != CoincidentSurfaces::none) {
        const double t = coincident_.passage(place.surface, ray, crossing.t, crossing.entering);
        const double away = std::abs(t - crossing.t) * glm::length(ray.direction);
        if (away <= farthest_shift * (coincident_.farthest() + group_size(ray))) {
          crossing.t = t;
        }
      }
    }
    // Two that have changed places are none.
    for (std::uint32_t k = first; k + 1 < scratch.crossings_.size();) {
      const auto at = scratch.crossings_.begin() + k;
      if (at[1].t < at[0].t) {
        scratch.crossings_.erase(at, at + 2);
        k = first;
      } else {
        ++k;
      }
    }
    for (std::uint32_t k = first; k < scratch.crossings_.size(); ++k) {
      scratch.events_.push_back({.t = scratch.crossings_[k].t, .leaf = i, .crossing = k});
    }
  }
  std::ranges::sort(scratch.events_, [](const auto& a, const auto& b) {
    return std::tie(a.t, a.crossing) < std::tie(b.t, b.crossing);
  });
}

void LinearSolid::report_group(std::size_t begin, std::size_t end, Scratch& scratch) const {
  for (const std::uint32_t node : scratch.touched_) {
    scratch.changed_[node] = 0;
  }
  scratch.touched_.clear();
  for (std::size_t i = begin; i < end; ++i) {
    toggle(scratch.events_[i].leaf, scratch);
  }
  if (scratch.changed_[gates_.size() - 1] == 0) {
    return;
  }
  const auto responsible = [&](std::uint32_t leaf) {
    std::uint32_t node = leaf_node_[leaf];
    while (scratch.changed_[node] != 0 && gates_[node].parent != CsgTree::no_parent) {
      node = gates_[node].parent;
    }
    return scratch.changed_[node] != 0;
  };
  const auto rank = [&](const Scratch::Event& event) {
    const std::uint32_t face = scratch.crossings_[event.crossing].face;
    return std::tuple(gates_[leaf_node_[event.leaf]].subtracted,
                      static_cast<std::uint32_t>(tree_.leaves()[event.leaf].first_face) + face);
  };
  const Scratch::Event* best = nullptr;
  for (std::size_t i = begin; i < end; ++i) {
    const Scratch::Event& event = scratch.events_[i];
    const std::uint32_t node = leaf_node_[event.leaf];
    // A leaf crossed to and fro and to again is met where it goes the way it went on the whole.
    const bool entered = scratch.true_inputs_[node] != 0;
    if (scratch.crossings_[event.crossing].entering == entered && responsible(event.leaf) &&
        (best == nullptr || rank(event) < rank(*best))) {
      best = &event;
    }
  }
  assert(best != nullptr);
  const Crossing& crossing = scratch.crossings_[best->crossing];
  scratch.boundaries.push_back({.t = crossing.t,
                                .leaf = best->leaf,
                                .face = crossing.face,
                                .piece = crossing.piece,
                                .entering = inside(scratch),
                                .subtracted = gates_[leaf_node_[best->leaf]].subtracted,
                                .normal = crossing.normal});
}

bool LinearSolid::cross(const Ray& ray, Scratch& scratch) const {
  scratch.boundaries.clear();
  scratch.crossings_.clear();
  if (gates_.size() == 1) {
    const bool starts_inside = tree_.leaves().front().shape.cross_local(ray, scratch.crossings_);
    for (const Crossing& crossing : scratch.crossings_) {
      scratch.boundaries.push_back({.t = crossing.t,
                                    .face = crossing.face,
                                    .piece = crossing.piece,
                                    .entering = crossing.entering,
                                    .normal = crossing.normal});
    }
    return starts_inside;
  }
  scratch.events_.clear();
  scratch.touched_.clear();
  scratch.true_inputs_ = true_inputs_;
  scratch.changed_.assign(gates_.size(), 0);
  gather(ray, scratch);
  const bool starts_inside = inside(scratch);

  const double group_length = group_size(ray) / glm::length(ray.direction);
  for (std::size_t begin = 0; begin < scratch.events_.size();) {
    const double last = scratch.events_[begin].t + group_length;
    std::size_t end = begin + 1;
    while (end < scratch.events_.size() && scratch.events_[end].t <= last) {
      ++end;
    }
    report_group(begin, end, scratch);
    begin = end;
  }
  return starts_inside;
}

}  // namespace raycat
