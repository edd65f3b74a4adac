#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <mutex>
#include <unordered_map>

#include "antialias/sampler.hpp"
#include "raytree/ray_tree.hpp"

namespace raycat {

/// Ray trees by number, which any number of threads may fill at once. Equal trees have equal
/// numbers; which those are depends on who came first.
class TreeTable {
 public:
  TreeId intern(const RayTree& tree);

  /// The tree of a number. The reference stays good.
  const RayTree& tree(TreeId id) const;

 private:
  static constexpr std::uint32_t shard_count = 64;

  struct Shard {
    mutable std::mutex mutex;
    std::unordered_multimap<std::uint64_t, std::uint32_t> known;  // hash to place
    std::deque<RayTree> trees;
  };

  std::array<Shard, shard_count> shards_;
};

}  // namespace raycat
