#include "csg/leaf_index.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace raycat {
namespace {

constexpr std::uint32_t most_entries = 3;  // of a node without nodes below
constexpr int bins = 16;

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

}  // namespace

LeafIndex::LeafIndex(std::span<const Bounds> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto box = static_cast<std::uint32_t>(i);
    if (boxes[i].empty()) {
      continue;
    }
    if (boxes[i].finite()) {
      entries_.push_back({.bounds = boxes[i], .box = box});
    } else {
      unbounded_.push_back(box);
    }
  }
  build();
}

// Parts the entries from `begin` to `end` in two, and returns where the second part begins.
std::uint32_t LeafIndex::split(std::uint32_t begin, std::uint32_t end) {
  const auto first = entries_.begin() + begin;
  const auto last = entries_.begin() + end;
  Bounds centers;
  std::for_each(first, last, [&](const Entry& entry) { centers.include(entry.bounds.center()); });
  const glm::dvec3 size = centers.max - centers.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto bin_of = [&](const Entry& entry) {
    const double place = (entry.bounds.center()[axis] - centers.min[axis]) / size[axis];
    return std::clamp(static_cast<int>(place * bins), 0, bins - 1);
  };
  if (size[axis] > 0.0) {
    std::array<Bin, bins> bin;
    std::for_each(first, last, [&](const Entry& entry) {
      Bin& its = bin[static_cast<std::size_t>(bin_of(entry))];
      its.bounds.include(entry.bounds);
      ++its.count;
    });
    if (const int cut = best_cut(bin); cut >= 0) {
      const auto middle =
          std::partition(first, last, [&](const Entry& entry) { return bin_of(entry) <= cut; });
      return static_cast<std::uint32_t>(middle - entries_.begin());
    }
  }
  return begin + (end - begin) / 2;  // no cut is better than another
}

void LeafIndex::build() {
  struct Part {
    std::uint32_t begin;
    std::uint32_t end;
  };
  struct Open {
    std::uint32_t node;
    std::uint32_t end;
  };
  std::vector<Part> parts;
  std::vector<Open> open;  // nodes whose parts are not all made yet
  if (!entries_.empty()) {
    parts.push_back({.begin = 0, .end = static_cast<std::uint32_t>(entries_.size())});
  }
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    for (; !open.empty() && open.back().end <= part.begin; open.pop_back()) {
      nodes_[open.back().node].skip = number;
    }
    Node& node = nodes_.emplace_back();
    open.push_back({.node = number, .end = part.end});
    for (std::uint32_t k = part.begin; k < part.end; ++k) {
      node.bounds.include(entries_[k].bounds);
    }
    if (part.end - part.begin <= most_entries) {
      node.begin = part.begin;
      node.end = part.end;
    } else {
      const std::uint32_t middle = split(part.begin, part.end);
      parts.push_back({.begin = middle, .end = part.end});
      parts.push_back({.begin = part.begin, .end = middle});
    }
  }
  for (const Open& each : open) {
    nodes_[each.node].skip = static_cast<std::uint32_t>(nodes_.size());
  }
}

}  // namespace raycat
