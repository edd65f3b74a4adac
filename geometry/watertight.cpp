#include "geometry/watertight.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/edge_uses.hpp"
#include "geometry/weld.hpp"

namespace raycat {
namespace {

std::string place(const glm::dvec3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

void check_values(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3& p = mesh.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw std::invalid_argument(
          fmt::format("vertex {} has a coordinate that is not finite: {}", i, place(p)));
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles[i][k] >= mesh.positions.size()) {
        throw std::invalid_argument(fmt::format("triangle {} has vertex {}, but there are {}", i,
                                                mesh.triangles[i][k], mesh.positions.size()));
      }
    }
  }
}

// A triangle with two corners at one place runs along its only edge both ways, so that leaving
// it out opens nothing. One whose corners are three places in a row does join edges, and stays.
void weld_triangles(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = weld(mesh.positions);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::uvec3 welded{first[t.x], first[t.y], first[t.z]};
    if (welded.x != welded.y && welded.y != welded.z && welded.z != welded.x) {
      mesh.triangles[kept] = welded;
      mesh.faces[kept] = mesh.faces[i];
      ++kept;
    }
  }
  mesh.triangles.resize(kept);
  mesh.faces.resize(kept);
}

void leave_out_unused_positions(TriangleMesh& mesh) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> renumbered(mesh.positions.size(), unused);
  for (const glm::uvec3& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      renumbered[triangle[k]] = 0;
    }
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (renumbered[i] != unused) {
      renumbered[i] = kept;
      mesh.positions[kept] = mesh.positions[i];
      ++kept;
    }
  }
  mesh.positions.resize(kept);
  for (glm::uvec3& triangle : mesh.triangles) {
    triangle = {renumbered[triangle.x], renumbered[triangle.y], renumbered[triangle.z]};
  }
}

void check_edges(const TriangleMesh& mesh) {
  const EdgeUses edges(mesh.triangles, mesh.positions.size());
  std::size_t bad = 0;
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
  bool first_is_open = false;
  edges.for_each([&](std::span<const std::uint32_t> uses) {
    std::ptrdiff_t balance = 0;
    for (const std::uint32_t half : uses) {
      const bool upwards =
          half_edge_start(mesh.triangles, half) < half_edge_end(mesh.triangles, half);
      balance += upwards ? 1 : -1;
    }
    if (balance != 0) {
      ++bad;
      if (uses.front() < first) {
        first = uses.front();
        first_is_open = uses.size() == 1;
      }
    }
  });
  if (bad != 0) {
    throw std::invalid_argument(
        fmt::format("edge {} to {} is {}; {} open or inconsistently oriented",
                    place(mesh.positions[half_edge_start(mesh.triangles, first)]),
                    place(mesh.positions[half_edge_end(mesh.triangles, first)]),
                    first_is_open ? "open" : "inconsistently oriented",
                    bad == 1 ? std::string("1 edge is") : fmt::format("{} edges are", bad)));
  }
}

// By the divergence theorem, about the middle of the mesh so that a far one loses nothing.
void check_volume(const TriangleMesh& mesh) {
  const glm::dvec3 center = bounds(mesh).center();
  double volume = 0.0;
  double magnitude = 0.0;  // the same sums with no sign, to which rounding errors are relative
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[triangle.x] - center;
    const glm::dvec3 b = mesh.positions[triangle.y] - center;
    const glm::dvec3 c = mesh.positions[triangle.z] - center;
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    const glm::dvec3 s = glm::abs(b);
    const glm::dvec3 t = glm::abs(c);
    magnitude += glm::dot(glm::abs(a), glm::dvec3(s.y * t.z + s.z * t.y, s.z * t.x + s.x * t.z,
                                                  s.x * t.y + s.y * t.x));
  }
  const double error = 2.0 * std::numeric_limits<double>::epsilon() * magnitude;
  if (!std::isfinite(magnitude)) {
    throw std::invalid_argument("the mesh is too large: its volume overflows");
  }
  if (std::abs(volume) <= error) {
    throw std::invalid_argument("the mesh has no volume");
  }
  if (volume < 0.0) {
    throw std::invalid_argument(
        fmt::format("the mesh is inside out: its volume is {:.6g}", volume));
  }
}

}  // namespace

TriangleMesh watertight(TriangleMesh mesh) {
  assert(mesh.faces.size() == mesh.triangles.size());
  check_values(mesh);
  weld_triangles(mesh);
  if (mesh.triangles.empty()) {
    throw std::invalid_argument("the mesh has no volume");
  }
  leave_out_unused_positions(mesh);
  check_edges(mesh);
  check_volume(mesh);
  return mesh;
}

}  // namespace raycat
