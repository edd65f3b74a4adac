#include "modelling/mesh_minkowski_sum.hpp"

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "modelling/convex_hull.hpp"
#include "modelling/nef.hpp"

namespace raycat {
namespace {

using Corners = std::vector<glm::dvec3>;

constexpr std::size_t most_sums = 100'000'000;

std::size_t corners_of(const std::vector<Corners>& parts) {
  std::size_t count = 0;
  for (const Corners& part : parts) {
    count += part.size();
  }
  return count;
}

// The sum of convex bodies is the hull of the sums of their corners.
TriangleMesh sum(const Corners& a, const Corners& b) {
  Corners sums;
  sums.reserve(a.size() * b.size());
  for (const glm::dvec3& p : a) {
    for (const glm::dvec3& q : b) {
      sums.push_back(p + q);
    }
  }
  return convex_hull(sums);
}

}  // namespace

TriangleMesh minkowski_sum(const TriangleMesh& a, const TriangleMesh& b) {
  const std::vector<Corners> parts_of_a = convex_parts(a);
  const std::vector<Corners> parts_of_b = convex_parts(b);
  const std::size_t corners_of_a = corners_of(parts_of_a);
  const std::size_t corners_of_b = corners_of(parts_of_b);
  if (corners_of_a == 0 || corners_of_b == 0) {
    return {};  // flat ones enclose nothing
  }
  if (corners_of_a > most_sums / corners_of_b) {
    throw std::runtime_error("too many corners to sum in pairs");
  }
  if (parts_of_a.size() == 1 && parts_of_b.size() == 1) {
    return sum(parts_of_a.front(), parts_of_b.front());
  }
  std::vector<TriangleMesh> sums;
  for (const Corners& p : parts_of_a) {
    for (const Corners& q : parts_of_b) {
      sums.push_back(sum(p, q));
    }
  }
  return united(sums);
}

}  // namespace raycat
