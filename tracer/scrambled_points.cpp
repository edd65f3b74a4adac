#include "tracer/scrambled_points.hpp"

namespace raycat {
namespace {

// A bijection whose every bit depends on every bit (the finalizer of SplitMix64).
std::uint64_t mixed(std::uint64_t bits) noexcept {
  bits += 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31);
}

// Binary digits after the point, the first on top.
std::uint32_t first_dimension(std::uint32_t index) noexcept {
  std::uint32_t digits = 0;
  for (std::uint32_t digit = 1U << 31; index != 0; index >>= 1, digit >>= 1) {
    digits |= (index & 1U) != 0 ? digit : 0U;
  }
  return digits;
}

// The generator matrix is Pascal's triangle modulo 2.
std::uint32_t second_dimension(std::uint32_t index) noexcept {
  std::uint32_t digits = 0;
  for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1) {
    digits ^= (index & 1U) != 0 ? column : 0U;
  }
  return digits;
}

double scrambled(std::uint32_t digits, std::uint64_t seed) noexcept {
  std::uint32_t out = 0;
  for (int k = 31; k >= 0; --k) {
    // The digits above the k-th, with a one before them so that 0 and 00 differ.
    const std::uint64_t above = (std::uint64_t{1} << 32 | digits) >> (k + 1);
    const auto flip = static_cast<std::uint32_t>(mixed(seed ^ above) & 1U);
    out |= (((digits >> k) & 1U) ^ flip) << k;
  }
  return (out + 0.5) * 0x1p-32;
}

}  // namespace

ScrambledPoints::ScrambledPoints(std::uint64_t seed) noexcept
    : x_seed_(mixed(2 * seed)), y_seed_(mixed(2 * seed + 1)) {}

glm::dvec2 ScrambledPoints::operator()(std::uint32_t index) const noexcept {
  return {scrambled(first_dimension(index), x_seed_), scrambled(second_dimension(index), y_seed_)};
}

}  // namespace raycat
