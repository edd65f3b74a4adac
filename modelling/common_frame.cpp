#include "modelling/common_frame.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace raycat {
namespace {

constexpr double least_volume = 0.3;  // of three axes: flatter frames would lose digits

std::optional<glm::dmat3> frame_of(const Affine& transform) {
  glm::dmat3 axes(transform.matrix());
  for (int column = 0; column < 3; ++column) {
    axes[column] = glm::normalize(axes[column]);
  }
  if (glm::determinant(axes) < 0.0) {
    axes[2] = -axes[2];
  }
  return glm::determinant(axes) >= least_volume ? std::optional(axes) : std::nullopt;
}

bool along_world_axes(const glm::dmat3& axes) {
  for (int column = 0; column < 3; ++column) {
    int zeros = 0;
    for (int row = 0; row < 3; ++row) {
      zeros += axes[column][row] == 0.0 ? 1 : 0;
    }
    if (zeros < 2) {
      return false;
    }
  }
  return true;
}

// The same for frames that rounding alone tells apart.
std::array<std::int64_t, 9> key(const glm::dmat3& axes) {
  constexpr double steps = 1e7;
  std::array<std::int64_t, 9> out{};
  for (std::size_t i = 0; i < 9; ++i) {
    out[i] = std::llround(axes[static_cast<int>(i / 3)][static_cast<int>(i % 3)] * steps);
  }
  return out;
}

}  // namespace

glm::dmat3 common_frame(const CsgTree& tree) {
  const glm::dmat3 identity(1.0);
  std::map<std::array<std::int64_t, 9>, std::size_t> count;
  glm::dmat3 best = identity;
  std::size_t most = 0;
  for (const CsgLeaf& leaf : tree.leaves()) {
    std::optional<glm::dmat3> axes = frame_of(leaf.shape.transform());
    if (!axes) {
      continue;
    }
    if (along_world_axes(*axes)) {
      axes = identity;
    }
    const std::size_t known = ++count[key(*axes)];
    if (known > most) {
      most = known;
      best = *axes;
    }
  }
  return best;
}

}  // namespace raycat
