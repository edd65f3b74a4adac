#include "modelling/leaf_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "csg/coincident_leaves.hpp"
#include "csg/set_bounds.hpp"
#include "geometry/tessellate.hpp"
#include "modelling/common_frame.hpp"
#include "modelling/flush_planes.hpp"

namespace raycat {
namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 23;

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

// A leaf's triangles, and the piece of its surface that each is of, `none` if it is of none.
struct Pieces {
  TriangleMesh mesh;
  std::vector<std::uint32_t> piece;
};

constexpr std::uint32_t none = FlushTriangles::none;

// A box whose sides are the leaf's one face; piece 0 is that of the last half axis, if it is given.
Pieces box_mesh(const glm::dvec3& centre, const glm::dmat3& half_axes, bool has_piece) {
  constexpr std::uint32_t last = 5;
  TriangleMesh mesh = tessellate(Box{.size = glm::dvec3(2.0)}, 0.0);
  for (glm::dvec3& position : mesh.positions) {
    position = centre + half_axes * position;
  }
  std::vector<std::uint32_t> piece;
  for (std::uint32_t& face : mesh.faces) {
    piece.push_back(has_piece && face == last ? 0 : none);
    face = 0;
  }
  mesh.face_count = 1;
  return {std::move(mesh), std::move(piece)};
}

// The part of a half-space that lies in `around` and some of what is beyond; nothing if it does
// not come near.
Pieces clipped_half_space(const Affine& transform, const Bounds& around) {
  const glm::dvec3 normal = transform.normal({0.0, 1.0, 0.0});
  const double reach = 2.0 * glm::length(around.half_size());
  const double depth = glm::dot(transform.point(glm::dvec3(0.0)) - around.center(), normal);
  if (depth <= -reach) {
    return {};
  }
  if (depth >= reach) {
    return box_mesh(around.center(), glm::dmat3(reach), false);
  }
  glm::dvec3 aside(0.0);
  aside[std::abs(normal.x) < 0.7 ? 0 : 1] = 1.0;
  const glm::dvec3 u = glm::normalize(glm::cross(normal, aside));
  const glm::dvec3 v = glm::cross(normal, u);
  const double half = 0.5 * (depth + reach);  // from `reach` below the centre up to the plane
  const glm::dvec3 centre = around.center() + (depth - half) * normal;
  return box_mesh(centre, glm::dmat3(reach * u, reach * v, half * normal), true);
}

Pieces world_triangles(const PlacedShape& shape, const Bounds& around, double chord_error) {
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
  std::vector<std::uint32_t> piece = mesh.faces;
  if (std::holds_alternative<MeshShape>(shape.shape())) {
    std::iota(piece.begin(), piece.end(), 0U);
  }
  return {std::move(mesh), std::move(piece)};
}

// Whose shape the leaf's is taken to be: a ball or a ring that coincides with another's is that.
std::uint32_t same_shape(const CsgTree& tree, const CoincidentSurfaces& coincident,
                         std::uint32_t leaf) {
  const Shape& shape = tree.leaves()[leaf].shape.shape();
  const std::uint32_t surface = coincident.place(leaf, 0).surface;
  if (surface == none ||
      !(std::holds_alternative<Sphere>(shape) || std::holds_alternative<Torus>(shape))) {
    return leaf;
  }
  const std::uint32_t other = coincident.largest(surface).part;
  return tree.leaves()[other].shape.shape().index() == shape.index() ? other : leaf;
}

// The surfaces in which the triangles lie, of pieces of the leaves.
FlushTriangles flush_triangles(const LeafTriangles& leaves, const std::vector<std::uint32_t>& piece,
                               const CoincidentSurfaces& coincident) {
  FlushTriangles out{.owner = leaves.leaf};
  out.spanning.assign(coincident.surfaces(), none);
  std::vector<double> most(coincident.surfaces(), 0.0);
  for (std::uint32_t i = 0; i < piece.size(); ++i) {
    const std::uint32_t surface =
        piece[i] == none ? none : coincident.place(leaves.leaf[i], piece[i]).surface;
    out.surface.push_back(surface);
    if (surface == none || !coincident.flat(surface)) {
      continue;
    }
    // Half-spaces and caps have no corners of their own: those of a triangle of the largest piece
    // are in its plane but for rounding.
    const bool largest = coincident.largest(surface) ==
                         CoincidentSurfaces::PieceId{.part = leaves.leaf[i], .piece = piece[i]};
    const glm::uvec3& t = leaves.mesh.triangles[i];
    const std::vector<glm::dvec3>& p = leaves.mesh.positions;
    const double area = glm::length(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
    if (largest && area > most[surface]) {
      most[surface] = area;
      out.spanning[surface] = i;
    }
  }
  return out;
}

void append(const Pieces& pieces, std::uint32_t leaf, LeafTriangles& out,
            std::vector<std::uint32_t>& piece) {
  const TriangleMesh& mesh = pieces.mesh;
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
  piece.insert(piece.end(), pieces.piece.begin(), pieces.piece.end());
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
  const Bounds around = bounded_leaves(tree);
  const double size = glm::length(around.half_size());
  const double tolerance = coincidence_tolerance(around);
  const CoincidentSurfaces coincident = coincident_leaves(tree);
  const double margin = 8.0 * tolerance;
  const std::vector<Bounds> reach = leaf_reach(tree, bounds, margin);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t leaf = 0; leaf < reach.size(); ++leaf) {
    if (!reach[leaf].empty()) {
      const CsgLeaf& as = tree.leaves()[same_shape(tree, coincident, leaf)];
      append(world_triangles(as.shape, around, rule.chord_error * size), leaf, out, piece);
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
  out.corners = onto_flush_planes(out.mesh.positions, out.mesh.triangles,
                                  flush_triangles(out, piece, coincident), tolerance);
  for (std::size_t i = 0; i < out.corners.size(); ++i) {
    out.mesh.positions[i] = rounded(out.corners[i]);
  }
  return out;
}

}  // namespace raycat
