#include "geometry/watertight.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "geometry/closed_edges.hpp"
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

// A side of a triangle from a corner to the next, with the vertices between them.
struct Side {
  std::uint32_t corner = 0;
  std::span<const std::uint32_t> inside;
};

// Triangles that have each vertex of the sides as a corner, none of them without area.
void cut(const Side& ab, const Side& bc, const Side& ca, std::vector<glm::uvec3>& out) {
  if (!ab.inside.empty()) {
    const std::size_t half = ab.inside.size() / 2;
    const std::uint32_t middle = ab.inside[half];
    cut({.corner = ab.corner, .inside = ab.inside.first(half)}, {.corner = middle, .inside = {}},
        ca, out);
    cut({.corner = middle, .inside = ab.inside.subspan(half + 1)}, bc,
        {.corner = ca.corner, .inside = {}}, out);
  } else if (!bc.inside.empty() || !ca.inside.empty()) {
    cut(bc, ca, ab, out);
  } else {
    out.emplace_back(ab.corner, bc.corner, ca.corner);
  }
}

void cut_triangles(TriangleMesh& mesh, std::vector<EdgePart> parts) {
  std::ranges::sort(parts, {},
                    [](const EdgePart& part) { return std::pair(part.half, part.from); });
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> faces;
  auto next = parts.begin();
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array<std::vector<std::uint32_t>, 3> inside;
    for (std::uint32_t k = 0; k < 3; ++k) {
      for (; next != parts.end() && next->half == 3 * i + k; ++next) {
        if (next->from_vertex() != half_edge_start(mesh.triangles, next->half)) {
          inside[k].push_back(next->from_vertex());
        }
      }
    }
    const glm::uvec3& t = mesh.triangles[i];
    cut({.corner = t.x, .inside = inside[0]}, {.corner = t.y, .inside = inside[1]},
        {.corner = t.z, .inside = inside[2]}, triangles);
    faces.resize(triangles.size(), mesh.faces[i]);
  }
  mesh.triangles = std::move(triangles);
  mesh.faces = std::move(faces);
}

void close_edges(TriangleMesh& mesh) {
  EdgeBalance balance = edge_balance(mesh.positions, mesh.triangles);
  if (balance.bad != 0) {
    throw std::invalid_argument(fmt::format(
        "edge {} to {} is {}; {} open or inconsistently oriented",
        place(mesh.positions[half_edge_start(mesh.triangles, balance.first)]),
        place(mesh.positions[half_edge_end(mesh.triangles, balance.first)]),
        balance.is_open ? "open" : "inconsistently oriented",
        balance.bad == 1 ? std::string("1 edge is") : fmt::format("{} edges are", balance.bad)));
  }
  if (!balance.cut.empty()) {
    cut_triangles(mesh, std::move(balance.cut));
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
  close_edges(mesh);
  check_volume(mesh);
  return mesh;
}

}  // namespace raycat
