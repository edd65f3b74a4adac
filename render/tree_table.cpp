#include "render/tree_table.hpp"

namespace raycat {
namespace {

std::uint64_t hash(const RayTree& tree) {
  std::uint64_t hash = tree.size();
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  };
  for (const RayNode& node : tree) {
    mix(node.position);
    mix(node.lights);
    mix(static_cast<std::uint64_t>(node.surface));
  }
  return hash;
}

}  // namespace

TreeId TreeTable::intern(const RayTree& tree) {
  const std::uint64_t key = hash(tree);
  const auto number = static_cast<std::uint32_t>(key % shard_count);
  Shard& shard = shards_[number];
  const std::lock_guard lock(shard.mutex);
  const auto [first, last] = shard.known.equal_range(key);
  for (auto at = first; at != last; ++at) {
    if (shard.trees[at->second] == tree) {
      return TreeId{at->second * shard_count + number};
    }
  }
  const auto place = static_cast<std::uint32_t>(shard.trees.size());
  shard.trees.push_back(tree);
  shard.known.emplace(key, place);
  return TreeId{place * shard_count + number};
}

const RayTree& TreeTable::tree(TreeId id) const {
  const auto number = static_cast<std::uint32_t>(id);
  const Shard& shard = shards_[number % shard_count];
  const std::lock_guard lock(shard.mutex);
  return shard.trees[number / shard_count];
}

}  // namespace raycat
