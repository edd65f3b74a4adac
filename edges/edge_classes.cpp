#include "edges/edge_classes.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace raycat {
namespace {

// The classes of two nodes at the same position.
std::uint8_t node_difference(const RayNode& a, const RayNode& b, const SurfaceTable& surfaces,
                             Granularity ids) {
  if (a.surface == b.surface) {
    return a.lights == b.lights ? std::uint8_t{0} : bit(EdgeClass::shadow);
  }
  const auto told = static_cast<std::uint32_t>(surfaces.count(ids));
  if (ids == Granularity::object || std::max(a.surface, b.surface) >= SurfaceId{told}) {
    return bit(EdgeClass::object);
  }
  const auto primitive = [&](const RayNode& node) {
    return ids == Granularity::face ? surfaces.primitive(node.surface)
                                    : PrimitiveId{static_cast<std::uint32_t>(node.surface)};
  };
  const PrimitiveId pa = primitive(a);
  const PrimitiveId pb = primitive(b);
  if (pa == pb) {
    return bit(EdgeClass::face);
  }
  return bit(surfaces.object(pa) == surfaces.object(pb) ? EdgeClass::primitive : EdgeClass::object);
}

// Below its highest bit, a position has a 1 for each reflection and a 0 for each refraction on
// the way to it.
std::uint8_t way_to(HeapPosition position) {
  const HeapPosition all_reflected = std::bit_floor(position) - 1;
  const HeapPosition way = position & all_reflected;
  std::uint8_t mask = 0;
  mask |= way != 0 ? bit(EdgeClass::reflection) : std::uint8_t{0};
  mask |= way != all_reflected ? bit(EdgeClass::refraction) : std::uint8_t{0};
  return mask;
}

// The classes of two trees whose nodes are in the order of their positions, and hence of levels.
std::uint8_t classes_between(const RayTree& a, const RayTree& b, const SurfaceTable& surfaces,
                             Granularity ids) {
  std::uint8_t mask = 0;
  int last_level = most_levels;
  auto in_a = a.begin();
  auto in_b = b.begin();
  while (in_a != a.end() || in_b != b.end()) {
    constexpr HeapPosition past = std::numeric_limits<HeapPosition>::max();
    const HeapPosition position =
        std::min(in_a != a.end() ? in_a->position : past, in_b != b.end() ? in_b->position : past);
    if (level(position) > last_level) {
      break;
    }
    const bool a_has = in_a != a.end() && in_a->position == position;
    const bool b_has = in_b != b.end() && in_b->position == position;
    const std::uint8_t difference =
        a_has && b_has ? node_difference(*in_a, *in_b, surfaces, ids) : bit(EdgeClass::object);
    if (difference != 0) {
      mask |= difference;
      mask |= way_to(position);
      last_level = level(position);
    }
    in_a += a_has ? 1 : 0;
    in_b += b_has ? 1 : 0;
  }
  return mask;
}

// Compares categories, each pair once and each tree read once.
class Comparer {
 public:
  Comparer(CategoryTrees& trees, const SurfaceTable& surfaces)
      : trees_(trees), surfaces_(surfaces), sorted_(trees.image().table.size()) {}

  std::uint8_t operator()(CategoryId a, CategoryId b) {
    if (a == b) {
      return 0;
    }
    const auto [low, high] = std::minmax(a, b);
    const auto [known, is_new] = known_.try_emplace(
        std::uint64_t{static_cast<std::uint32_t>(low)} << 32 | static_cast<std::uint32_t>(high));
    if (is_new) {
      known->second = classes_between(tree(low), tree(high), surfaces_, trees_.image().detail.ids);
    }
    return known->second;
  }

 private:
  const RayTree& tree(CategoryId id) {
    std::optional<RayTree>& tree = sorted_[static_cast<std::size_t>(id)];
    if (!tree) {
      tree = trees_.tree(id);
      std::ranges::sort(*tree, {}, &RayNode::position);
    }
    return *tree;
  }

  CategoryTrees& trees_;
  const SurfaceTable& surfaces_;
  std::vector<std::optional<RayTree>> sorted_;  // by category
  std::unordered_map<std::uint64_t, std::uint8_t> known_;
};

}  // namespace

std::string_view name(EdgeClass edge_class) {
  constexpr std::array<std::string_view, all_edge_classes.size()> names{
      "object", "primitive", "face", "shadow", "reflection", "refraction"};
  return names[static_cast<std::size_t>(std::countr_zero(bit(edge_class)))];
}

std::array<std::uint64_t, all_edge_classes.size()> EdgeClasses::counts() const {
  std::array<std::uint64_t, all_edge_classes.size()> counts{};
  for (const std::uint8_t mask : masks) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      counts[i] += mask >> i & 1u;
    }
  }
  return counts;
}

EdgeClasses classify_edges(CategoryTrees& trees, const SurfaceTable& surfaces) {
  const CategoryImage& categories = trees.image();
  EdgeClasses classes{.width = categories.width, .height = categories.height, .masks = {}};
  classes.masks.reserve(static_cast<std::size_t>(classes.width) *
                        static_cast<std::size_t>(classes.height));
  Comparer compare(trees, surfaces);
  for (int y = 0; y < classes.height; ++y) {
    for (int x = 0; x < classes.width; ++x) {
      const CategoryId here = categories.at(x, y);
      std::uint8_t mask = compare(here, categories.at(x + 1, y));
      mask |= compare(here, categories.at(x, y + 1));
      mask |= compare(here, categories.at(x + 1, y + 1));
      classes.masks.push_back(mask);
    }
  }
  return classes;
}

}  // namespace raycat
