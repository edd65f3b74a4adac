#include "tests/bench/bumpy_sphere.hpp"

#include <cmath>
#include <numbers>

namespace raycat::bench {
namespace {

constexpr std::uint32_t patch = 16;

glm::dvec3 bumpy_point(double longitude, double latitude) {
  const double radius = 1.0 + 0.08 * std::sin(9.0 * longitude) * std::sin(11.0 * latitude) +
                        0.01 * std::sin(83.0 * longitude) * std::cos(71.0 * latitude);
  return radius * glm::dvec3(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                             -std::cos(latitude) * std::sin(longitude));
}

}  // namespace

TriangleMesh bumpy_sphere(std::uint32_t columns, std::uint32_t rings) {
  TriangleMesh mesh;
  const std::uint32_t patches = (columns + patch - 1) / patch;
  const auto add = [&](const glm::uvec3& corners, std::uint32_t column, std::uint32_t ring) {
    mesh.triangles.push_back(corners);
    mesh.faces.push_back(ring / patch * patches + column / patch);
  };
  // Rings of vertices from south to north, between a vertex at each pole: the rows of triangles
  // at the poles are single, all others double.
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const double latitude = std::numbers::pi * ((ring + 1.0) / (rings + 1.0) - 0.5);
    for (std::uint32_t column = 0; column < columns; ++column) {
      mesh.positions.push_back(bumpy_point(2.0 * std::numbers::pi * column / columns, latitude));
    }
  }
  const std::uint32_t south = rings * columns;
  const std::uint32_t north = south + 1;
  mesh.positions.push_back(bumpy_point(0.0, -0.5 * std::numbers::pi));
  mesh.positions.push_back(bumpy_point(0.0, 0.5 * std::numbers::pi));
  for (std::uint32_t column = 0; column < columns; ++column) {
    const std::uint32_t next = (column + 1) % columns;
    add({south, next, column}, column, 0);
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t below = ring * columns;
      const std::uint32_t above = below + columns;
      add({below + column, below + next, above + next}, column, ring);
      add({below + column, above + next, above + column}, column, ring);
    }
    const std::uint32_t last = (rings - 1) * columns;
    add({last + column, last + next, north}, column, rings - 1);
  }
  mesh.face_count = patches * ((rings + patch - 1) / patch);
  return mesh;
}

}  // namespace raycat::bench
