#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace raycat {

/// Points that are spread over the unit square more evenly than chance does it, and yet any of them
/// may be anywhere: the first two dimensions of Sobol's sequence, each digit flipped at random by
/// those before it (Owen's scrambling). Of 2^k points from a multiple of 2^k on, one lies in each
/// of 2^k equal boxes, whatever their shape. What is random follows from the seed alone.
class ScrambledPoints {
 public:
  explicit ScrambledPoints(std::uint64_t seed) noexcept;

  /// Within the square, never on its border.
  glm::dvec2 operator()(std::uint32_t index) const noexcept;

 private:
  std::uint64_t x_seed_;
  std::uint64_t y_seed_;
};

}  // namespace raycat
