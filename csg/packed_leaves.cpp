#include "csg/packed_leaves.hpp"

#include <array>
#include <map>

namespace raycat {
namespace {

// In any total order of finite matrices.
std::array<double, 9> key(const glm::dmat3& m) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

}  // namespace

PackedLeaves::PackedLeaves(std::span<const CsgLeaf> leaves) {
  std::map<std::array<double, 9>, std::uint32_t> known{{key(glm::dmat3(1.0)), identity}};
  leaves_.reserve(leaves.size());
  for (const CsgLeaf& leaf : leaves) {
    const Affine& transform = leaf.shape.transform();
    const auto [found, added] = known.try_emplace(key(transform.inverse_linear()),
                                                  static_cast<std::uint32_t>(inverses_.size()));
    if (added) {
      inverses_.push_back(transform.inverse_linear());
    }
    leaves_.push_back({.shape = leaf.shape.shape(),
                       .translation = transform.translation(),
                       .linear = found->second});
  }
}

}  // namespace raycat
