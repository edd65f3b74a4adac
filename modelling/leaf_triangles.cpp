#include "modelling/leaf_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "csg/set_bounds.hpp"
#include "geometry/tessellate.hpp"
#include "modelling/common_frame.hpp"
#include "modelling/flush_planes.hpp"

namespace raycat {
namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 23;
constexpr double flush_tolerance = 1e-7;  // of the half diagonal, as in `Solid`

// An upper bound of how much longer the map makes a vector; what it is for turns and stretches
// along axes.
double most_stretch(const Affine& transform) {
  const glm::dmat3 linear(transform.matrix());
  const glm::dmat3 squared = glm::transpose(linear) * linear;
  double most = 0.0;
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 entries = glm::abs(squared[column]);
    most = std::max(most, entries.x + entries.y + entries.z);
  }
  return std::sqrt(most);
}

TriangleMesh box_mesh(const glm::dvec3& centre, const glm::dmat3& half_axes) {
  TriangleMesh mesh = tessellate(Box{.size = glm::dvec3(2.0)}, 0.0);
  for (glm::dvec3& position : mesh.positions) {
    position = centre + half_axes * position;
  }
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.face_count = 1;
  return mesh;
}

// The part of a half-space that lies in `around` and some of what is beyond; nothing if it does
// not come near.
TriangleMesh clipped_half_space(const Affine& transform, const Bounds& around) {
  const glm::dvec3 normal = transform.normal({0.0, 1.0, 0.0});
  const double reach = 2.0 * glm::length(around.half_size());
  const double depth = glm::dot(transform.point(glm::dvec3(0.0)) - around.center(), normal);
  if (depth <= -reach) {
    return {};
  }
  if (depth >= reach) {
    return box_mesh(around.center(), glm::dmat3(reach));
  }
  glm::dvec3 aside(0.0);
  aside[std::abs(normal.x) < 0.7 ? 0 : 1] = 1.0;
  const glm::dvec3 u = glm::normalize(glm::cross(normal, aside));
  const glm::dvec3 v = glm::cross(normal, u);
  const double half = 0.5 * (depth + reach);  // from `reach` below the centre up to the plane
  const glm::dvec3 centre = around.center() + (depth - half) * normal;
  return box_mesh(centre, glm::dmat3(reach * u, reach * v, half * normal));
}

TriangleMesh world_triangles(const PlacedShape& shape, const Bounds& around, double chord_error) {
  const Affine& transform = shape.transform();
  if (std::holds_alternative<HalfSpace>(shape.shape())) {
    return clipped_half_space(transform, around);
  }
  TriangleMesh mesh = tessellate(shape.shape(), chord_error / most_stretch(transform));
  for (glm::dvec3& position : mesh.positions) {
    position = transform.point(position);
  }
  if (transform.mirrored()) {
    for (glm::uvec3& triangle : mesh.triangles) {
      triangle = {triangle.x, triangle.z, triangle.y};
    }
  }
  return mesh;
}

void append(const TriangleMesh& mesh, std::uint32_t leaf, LeafTriangles& out) {
  if (mesh.triangles.size() > most_triangles - out.mesh.triangles.size()) {
    throw std::invalid_argument(
        fmt::format("the operands of a solid take at most {} triangles", most_triangles));
  }
  const auto first = static_cast<std::uint32_t>(out.mesh.positions.size());
  out.mesh.positions.insert(out.mesh.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const glm::uvec3& triangle : mesh.triangles) {
    out.mesh.triangles.push_back(triangle + first);
  }
  out.mesh.faces.insert(out.mesh.faces.end(), mesh.faces.begin(), mesh.faces.end());
  out.mesh.face_count = std::max(out.mesh.face_count, mesh.face_count);
  out.leaf.insert(out.leaf.end(), mesh.triangles.size(), leaf);
}

void to_frame(const glm::dmat3& frame, LeafTriangles& out) {
  if (frame == glm::dmat3(1.0)) {
    return;  // and the positions stay as they are to the last bit
  }
  out.frame = frame;
  const glm::dmat3 inverse = glm::inverse(frame);
  for (glm::dvec3& position : out.mesh.positions) {
    position = inverse * position;
  }
}

}  // namespace

LeafTriangles leaf_triangles(const CsgTree& tree, const TessellationRule& rule) {
  tree.require_complete();
  LeafTriangles out;
  const std::vector<Bounds> bounds = set_bounds(tree);
  if (bounds.back().empty()) {
    return out;
  }
  if (!bounds.back().finite()) {
    throw std::invalid_argument("the solid is not bounded: a half-space leaves it without end");
  }
  Bounds around = bounds.back();
  for (const CsgLeaf& leaf : tree.leaves()) {
    if (leaf.shape.bounds().finite()) {
      around.include(leaf.shape.bounds());
    }
  }
  const double size = glm::length(around.half_size());
  const double margin = 8.0 * flush_tolerance * size;
  const std::vector<Bounds> reach = leaf_reach(tree, bounds, margin);
  for (std::uint32_t leaf = 0; leaf < reach.size(); ++leaf) {
    if (!reach[leaf].empty()) {
      append(world_triangles(tree.leaves()[leaf].shape, around, rule.chord_error * size), leaf,
             out);
    }
  }
  for (std::size_t i = 0; i < out.mesh.triangles.size(); ++i) {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
      box.include(out.mesh.positions[out.mesh.triangles[i][k]]);
    }
    Bounds within = intersection(reach[out.leaf[i]], bounds.back());
    within = {.min = within.min - margin, .max = within.max + margin};
    out.wanted.push_back(intersection(box, within).empty() ? 0 : 1);
  }
  to_frame(common_frame(tree), out);
  out.corners =
      onto_flush_planes(out.mesh.positions, out.mesh.triangles, out.leaf, flush_tolerance * size);
  for (std::size_t i = 0; i < out.corners.size(); ++i) {
    out.mesh.positions[i] = rounded(out.corners[i]);
  }
  return out;
}

}  // namespace raycat
