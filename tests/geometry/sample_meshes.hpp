#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "geometry/mesh.hpp"
#include "geometry/mesh_faces.hpp"

namespace raycat::test {

/// Corner i is at the far end of x, y, z for bits 1, 2, 4 of i.
inline TriangleMesh box(const glm::dvec3& low, const glm::dvec3& high) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                         (i & 4) != 0 ? high.z : low.z);
  }
  const std::vector<std::vector<std::uint32_t>> faces{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return triangulate(std::move(corners), faces);
}

/// A regular prism of radius 1 from z = 0 to 1; its sides are faces, then the bottom and the top.
inline TriangleMesh prism(std::uint32_t sides) {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> bottom(sides);
  std::vector<std::uint32_t> top(sides);
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double u = 2.0 * std::numbers::pi * i / sides;
    points.emplace_back(std::cos(u), std::sin(u), 0.0);
    points.emplace_back(std::cos(u), std::sin(u), 1.0);
    const std::uint32_t j = (i + 1) % sides;
    faces.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
    top[i] = 2 * i + 1;
    bottom[sides - 1 - i] = 2 * i;
  }
  faces.push_back(bottom);
  faces.push_back(top);
  return triangulate(std::move(points), faces);
}

inline TriangleMesh flipped(TriangleMesh mesh) {
  for (glm::uvec3& triangle : mesh.triangles) {
    triangle = {triangle.x, triangle.z, triangle.y};
  }
  return mesh;
}

/// Both meshes in one; the second's faces follow the first's.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t i = 0; i < b.triangles.size(); ++i) {
    a.triangles.push_back(b.triangles[i] + offset);
    a.faces.push_back(b.faces[i] + a.face_count);
  }
  a.face_count += b.face_count;
  return a;
}

/// A torus of `columns` by `rows` quadrilaterals, each cut in two; one face. `bumps` moves
/// vertices at random by up to that much.
inline TriangleMesh torus(std::uint32_t columns, std::uint32_t rows, double bumps = 0.0,
                          std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> bump(-bumps, bumps);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < columns; ++i) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      const double u = 2.0 * std::numbers::pi * i / columns;
      const double v = 2.0 * std::numbers::pi * j / rows;
      const double r = 1.0 + (0.4 + (bumps > 0.0 ? bump(random) : 0.0)) * std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
      const std::uint32_t a = i * rows + j;
      const std::uint32_t b = (i + 1) % columns * rows + j;
      const std::uint32_t c = (i + 1) % columns * rows + (j + 1) % rows;
      const std::uint32_t d = i * rows + (j + 1) % rows;
      mesh.triangles.emplace_back(a, b, c);
      mesh.triangles.emplace_back(a, c, d);
    }
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

/// A ball of radius 1 in `rings` by 2 `rings`; one face.
inline TriangleMesh ball(std::uint32_t rings) {
  const std::uint32_t sides = 2 * rings;
  TriangleMesh mesh;
  mesh.positions = {{0.0, 0.0, -1.0}, {0.0, 0.0, 1.0}};
  for (std::uint32_t i = 1; i < rings; ++i) {
    for (std::uint32_t j = 0; j < sides; ++j) {
      const double v = std::numbers::pi * i / rings;
      const double u = 2.0 * std::numbers::pi * j / sides;
      mesh.positions.emplace_back(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u),
                                  -std::cos(v));
    }
  }
  const auto at = [&](std::uint32_t ring, std::uint32_t side) {
    return 2 + (ring - 1) * sides + side % sides;
  };
  for (std::uint32_t j = 0; j < sides; ++j) {
    mesh.triangles.emplace_back(0U, at(1, j + 1), at(1, j));
    mesh.triangles.emplace_back(1U, at(rings - 1, j), at(rings - 1, j + 1));
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

inline TriangleMesh placed(TriangleMesh mesh, double scale, const glm::dvec3& offset) {
  for (glm::dvec3& p : mesh.positions) {
    p = scale * p + offset;
  }
  return mesh;
}

/// By the divergence theorem.
inline double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  }
  return sum / 6.0;
}

/// By solid angles.
inline double winding_number(const TriangleMesh& mesh, const glm::dvec3& point) {
  double angle = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x] - point;
    const glm::dvec3 b = mesh.positions[t.y] - point;
    const glm::dvec3 c = mesh.positions[t.z] - point;
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc +
                                                                 glm::dot(b, c) * la +
                                                                 glm::dot(c, a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace raycat::test
