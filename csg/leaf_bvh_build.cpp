#include <cassert>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "csg/leaf_bvh.hpp"

namespace raycat {
namespace {

constexpr double most = 1e300;  // of coordinates: that of a longer box may overflow
constexpr int bins = 16;

// Within 1 of the frame's origin, a line is told from a box with one rounding of the box's side,
// one of the line's origin, and three of the distance between them, which is 2 at most: 4 ulps.
constexpr double rounding = 6.0 * 0x1p-23;

// Splits by area up to here; then in halves, of which there are 31 at most.
constexpr std::uint32_t most_area_splits = 40;

bool bounded(const Bounds& box) {
  return glm::all(glm::greaterThan(box.min, glm::dvec3(-most))) &&
         glm::all(glm::lessThan(box.max, glm::dvec3(most)));
}

double half_area(const Bounds& box) {
  if (box.empty()) {
    return 0.0;
  }
  const glm::dvec3 size = box.max - box.min;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Bin {
  Bounds bounds;
  std::uint32_t count = 0;
};

// The last bin of the left side by the surface area heuristic; -1 if one side would be empty.
int best_cut(const std::array<Bin, bins>& bin) {
  std::array<double, bins> right{};
  Bin sum;
  for (int i = bins - 1; i > 0; --i) {
    sum.bounds.include(bin[static_cast<std::size_t>(i)].bounds);
    sum.count += bin[static_cast<std::size_t>(i)].count;
    right[static_cast<std::size_t>(i)] = half_area(sum.bounds) * sum.count;
  }
  const std::uint32_t all = sum.count + bin[0].count;
  sum = {};
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i + 1 < bins; ++i) {
    sum.bounds.include(bin[static_cast<std::size_t>(i)].bounds);
    sum.count += bin[static_cast<std::size_t>(i)].count;
    const double cost = half_area(sum.bounds) * sum.count + right[static_cast<std::size_t>(i) + 1];
    if (sum.count > 0 && sum.count < all && cost < least) {
      least = cost;
      best = i;
    }
  }
  return best;
}

// Parts the entries in two, and returns how many are in the first part.
template <typename Entry>
std::size_t split(std::span<Entry> entries, bool by_area) {
  Bounds centers;
  for (const Entry& entry : entries) {
    centers.include(entry.bounds.center());
  }
  const glm::dvec3 size = centers.max - centers.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (!by_area || !(size[axis] > 0.0)) {
    const std::size_t middle = entries.size() / 2;
    std::ranges::nth_element(entries, entries.begin() + static_cast<std::ptrdiff_t>(middle), {},
                             [&](const Entry& entry) { return entry.bounds.center()[axis]; });
    return middle;
  }
  const auto bin_of = [&](const Entry& entry) {
    const double place = (entry.bounds.center()[axis] - centers.min[axis]) / size[axis];
    return std::clamp(static_cast<int>(place * bins), 0, bins - 1);
  };
  std::array<Bin, bins> bin;
  for (const Entry& entry : entries) {
    Bin& its = bin[static_cast<std::size_t>(bin_of(entry))];
    its.bounds.include(entry.bounds);
    ++its.count;
  }
  const int cut = best_cut(bin);
  if (cut < 0) {  // areas that overflow
    return entries.size() / 2;
  }
  const auto second =
      std::ranges::partition(entries, [&](const Entry& entry) { return bin_of(entry) <= cut; });
  return entries.size() - second.size();
}

}  // namespace

// What is to become a child of a node.
struct LeafBvh::Part {
  std::span<Entry> entries;
  Bounds bounds;
  std::uint32_t splits = 0;

  Part() = default;
  Part(std::span<Entry> its, std::uint32_t above) : entries(its), splits(above) {
    for (const Entry& entry : entries) {
      bounds.include(entry.bounds);
    }
  }
};

LeafBvh::LeafBvh(std::span<const Bounds> boxes) {
  assert(boxes.size() <= box_bit);
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto box = static_cast<std::uint32_t>(i);
    if (boxes[i].empty()) {
      continue;
    }
    if (bounded(boxes[i])) {
      entries.push_back({.bounds = boxes[i], .box = box});
      bounds_.include(boxes[i]);
    } else {
      unbounded_.push_back(box);
    }
  }
  if (!entries.empty()) {
    build(std::move(entries));
  }
}

void LeafBvh::build(std::vector<Entry> entries) {
  struct Open {
    Part part;
    std::size_t parent = 0;
    std::size_t child = 0;
  };
  center_ = bounds_.center();
  const glm::dvec3 half = bounds_.half_size();
  scale_ = std::max({half.x, half.y, half.z});
  if (!(scale_ > 0.0)) {
    scale_ = 1.0;
  }
  std::vector<Open> open;  // in preorder, so that what is near in space is near in memory
  open.push_back({.part = Part(entries, 0)});
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    const std::size_t number = nodes_.size();
    if (number > 0) {
      nodes_[at.parent].child[at.child] = static_cast<std::uint32_t>(number);
    }
    nodes_.emplace_back();

    std::array<Part, width> parts{at.part};
    std::size_t count = 1;
    while (count < width) {
      const auto worth = [](const Part& part) {
        return std::pair(part.entries.size() > 1 ? half_area(part.bounds) : -1.0,
                         part.entries.size());
      };
      Part& widest = *std::ranges::max_element(parts.begin(), parts.begin() + count, {}, worth);
      if (widest.entries.size() < 2) {
        break;
      }
      const std::uint32_t splits = widest.splits + 1;
      const std::span<Entry> all = widest.entries;
      const std::size_t middle = split(all, splits <= most_area_splits);
      widest = Part(all.first(middle), splits);
      parts[count++] = Part(all.subspan(middle), splits);
    }

    for (std::size_t k = width; k-- > 0;) {
      set_child(nodes_[number], k, parts[k].bounds);
      if (parts[k].entries.size() == 1) {
        nodes_[number].child[k] = parts[k].entries.front().box | box_bit;
      } else if (k < count) {
        open.push_back({.part = parts[k], .parent = number, .child = k});
      }
    }
  }
  nodes_.shrink_to_fit();
  bounds_.min -= 2.0 * rounding * scale_;
  bounds_.max += 2.0 * rounding * scale_;
}

void LeafBvh::set_child(Node& node, std::size_t child, const Bounds& box) const {
  const glm::dvec3 far = glm::abs(center_);
  const double margin = rounding + 0x1p-50 * std::max({far.x, far.y, far.z}) / scale_;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const bool there = !box.empty();
    const double low = there ? (box.min[axis] - center_[axis]) / scale_ - margin : 2.0;
    const double high = there ? (box.max[axis] - center_[axis]) / scale_ + margin : -2.0;
    node.sides[i][child] = static_cast<float>(low);
    node.sides[i + 3][child] = static_cast<float>(high);
  }
}

}  // namespace raycat
