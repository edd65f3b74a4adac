#include "modelling/evaluate.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/mesh_faces.hpp"
#include "modelling/arrangement.hpp"
#include "modelling/leaf_triangles.hpp"
#include "modelling/surviving_pieces.hpp"

namespace raycat {
namespace {

// Triangles whose corners are in a row have no inside that could be boundary.
void leave_out_degenerate(LeafTriangles& leaves) {
  for (std::size_t i = 0; i < leaves.wanted.size(); ++i) {
    const glm::uvec3& t = leaves.mesh.triangles[i];
    const auto& p = leaves.corners;
    if (leaves.wanted[i] != 0 && CGAL::collinear(p[t.x], p[t.y], p[t.z])) {
      leaves.wanted[i] = 0;
    }
  }
}

// Numbers what is used from 0, and gives it positions without doubles.
class Corners {
 public:
  Corners(const std::vector<Exact::Point_3>& points, const glm::dmat3& frame,
          std::vector<glm::dvec3>& positions)
      : points_(points), frame_(frame), positions_(positions), number_(points.size(), unused) {}

  std::uint32_t operator()(std::uint32_t point) {
    if (number_[point] == unused) {
      points_[point].exact();  // so that what is an exact double becomes it
      const glm::dvec3 p = frame_ * rounded(points_[point]) + 0.0;  // without negative zeros
      const auto [found, is_new] = number_of_.try_emplace(
          std::tuple(p.x, p.y, p.z), static_cast<std::uint32_t>(positions_.size()));
      if (is_new) {
        positions_.push_back(p);
      }
      number_[point] = found->second;
    }
    return number_[point];
  }

 private:
  static constexpr std::uint32_t unused = ~std::uint32_t{0};

  const std::vector<Exact::Point_3>& points_;
  const glm::dmat3& frame_;
  std::vector<glm::dvec3>& positions_;
  std::vector<std::uint32_t> number_;
  std::map<std::tuple<double, double, double>, std::uint32_t> number_of_;
};

}  // namespace

EvaluatedMesh evaluate(const CsgTree& tree, const TessellationRule& rule) {
  LeafTriangles leaves = leaf_triangles(tree, rule);
  leave_out_degenerate(leaves);
  const Arrangement arrangement = arrange(leaves.corners, leaves.mesh.triangles, leaves.wanted);
  const std::vector<Survival> survival = surviving_pieces(tree, leaves, arrangement);

  EvaluatedMesh out;
  Corners corner(arrangement.points, leaves.frame, out.mesh.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of;
  for (std::size_t i = 0; i < survival.size(); ++i) {
    if (survival[i] != Survival::gone) {
      const std::uint32_t triangle = arrangement.pieces[i].triangle;
      face_of[{leaves.leaf[triangle], leaves.mesh.faces[triangle]}] = 0;
    }
  }
  for (auto& [origin, face] : face_of) {
    face = static_cast<std::uint32_t>(out.origins.size());
    out.origins.push_back({.leaf = origin.first, .face = origin.second});
  }
  for (std::size_t i = 0; i < survival.size(); ++i) {
    if (survival[i] == Survival::gone) {
      continue;
    }
    const Arrangement::Piece& piece = arrangement.pieces[i];
    glm::uvec3 t(corner(piece.corners.x), corner(piece.corners.y), corner(piece.corners.z));
    if (t.x == t.y || t.y == t.z || t.z == t.x) {
      continue;  // rounded away, which joins its other two edges
    }
    if (survival[i] == Survival::turned) {
      std::swap(t.y, t.z);
    }
    out.mesh.triangles.push_back(t);
    out.mesh.faces.push_back(
        face_of.at({leaves.leaf[piece.triangle], leaves.mesh.faces[piece.triangle]}));
  }
  out.mesh.face_count = static_cast<std::uint32_t>(out.origins.size());
  return out;
}

}  // namespace raycat
