#include "modelling/smooth_runs.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include "geometry/crease.hpp"

namespace raycat {

std::vector<std::uint32_t> smooth_runs(const Contour& contour) {
  const std::size_t n = contour.size();
  const auto is_crease = [&](std::size_t i) {
    // The corners of a regular dodecagon are creases.
    constexpr double least = std::numbers::pi / 6.0 - crease_slack;
    const glm::dvec2 in = contour[i] - contour[(i + n - 1) % n];
    const glm::dvec2 out = contour[(i + 1) % n] - contour[i];
    const double turn = std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out));
    return std::abs(turn) >= least;
  };
  std::size_t first = 0;  // a crease, so that the run over the contour's end is one
  while (first < n && !is_crease(first)) {
    ++first;
  }
  std::vector<std::uint32_t> runs(n, 0);
  std::uint32_t run = 0;
  for (std::size_t step = 1; first < n && step < n; ++step) {
    const std::size_t edge = (first + step) % n;
    run += is_crease(edge) ? 1U : 0U;
    runs[edge] = run;
  }
  return runs;
}

}  // namespace raycat
