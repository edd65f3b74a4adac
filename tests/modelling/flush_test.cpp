// Where faces are about a tolerance apart, meshes have coincide what rays have.

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/coincident_leaves.hpp"
#include "csg/solid.hpp"
#include "geometry/tessellate.hpp"
#include "modelling/evaluate.hpp"

namespace raycat {
namespace {

Shape mesh_of(const Shape& shape) {
  return std::make_shared<const ClosedMesh>(tessellate(shape, 0.01));
}

// A slab from -0.5 to 0.5 less a plug from `gap` above its lower side up past the upper one, turned
// in it.
CsgTree cut(const Shape& slab, const Shape& plug, double gap, const glm::dmat4& map) {
  const glm::dmat4 turned = glm::rotate(glm::translate(map, glm::dvec3(0, 0.5 + gap, 0)),
                                        M_PI / 9.0, glm::dvec3(0, 1, 0));
  CsgTree tree;
  const auto a = tree.add({.shape = PlacedShape(slab, Affine(map))});
  const auto b = tree.add({.shape = PlacedShape(plug, Affine(turned)), .first_face = SurfaceId{6}});
  tree.add(Operation::difference, std::array{a, b});
  return tree;
}

// Of what faces down, and of what faces up at the same height to about the gap.
std::pair<double, double> area_at(const TriangleMesh& mesh, const glm::dvec3& point,
                                  const glm::dvec3& up) {
  std::pair<double, double> area;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3& a = mesh.positions[t.x];
    const glm::dvec3 across = 0.5 * glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    const double along = glm::dot(across, up);
    if (std::abs(along) > 0.99 * glm::length(across) && std::abs(glm::dot(a - point, up)) < 1e-3) {
      (along < 0.0 ? area.first : area.second) += glm::length(across);
    }
  }
  return area;
}

TEST_CASE("a floor is in the mesh where rays meet it", "[modelling][flush]") {
  const Box slab{.size = {4, 1, 4}};
  const Box plug{.size = {2, 2, 2}};
  const Cylinder drill{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0};
  struct Pair {
    Shape slab;
    Shape plug;
    double hole = 4.0;  // its area
  };
  const std::vector<Pair> pairs{{slab, plug},
                                {slab, drill, M_PI},
                                {mesh_of(slab), plug},
                                {slab, mesh_of(drill), M_PI},
                                {mesh_of(slab), mesh_of(plug)}};
  int floors = 0;
  int holes = 0;
  for (const double angle : {0.0, M_PI / 9.0, 1.0}) {
    const glm::dmat4 map =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, 3.0) * angle), angle,
                    glm::normalize(glm::dvec3(angle - 0.5, 1.0, angle)));
    for (const auto& [one, other, hole] : pairs) {
      const double tolerance = coincidence_tolerance(bounded_leaves(cut(one, other, 0.0, map)));
      for (const double width : {-1.0, -0.5, 0.0, 0.5, 0.99, 1.0, 1.01, 2.0, 50.0}) {
        CAPTURE(one.index(), other.index(), angle, width);
        const CsgTree tree = cut(one, other, width * tolerance, map);
        const glm::dvec3 up(glm::dmat3(map) * glm::dvec3(0, 1, 0));
        const glm::dvec3 point(map * glm::dvec4(0.1, -0.5, 0.2, 1.0));
        Solid::Scratch scratch;
        const bool floor =
            Solid(tree)
                .first({.origin = point + 3.0 * up, .direction = -up}, 0.0, INFINITY, scratch)
                .has_value();
        if (width != 1.0) {
          CHECK(floor == (width > 1.0));
        }
        ++(floor ? floors : holes);
        const auto [below, above] = area_at(evaluate(tree).mesh, point, up);
        // Drills have facets, which leave out about a hundredth.
        CHECK(below == Approx(floor ? 16.0 : 16.0 - hole).margin(0.02 * hole));
        CHECK(above == Approx(floor ? hole : 0.0).margin(floor ? 0.02 * hole : 0.0));
      }
    }
  }
  CHECK(floors > 40);
  CHECK(holes > 60);
}

TEST_CASE("balls and rings that coincide leave nothing of each other", "[modelling][flush]") {
  const std::array<std::pair<Shape, Shape>, 2> pairs{
      {{Sphere{.radius = 1.0}, Sphere{.radius = 1.0 - 1e-7}},
       {Torus{.radius = 1.0, .tube = 0.3}, Torus{.radius = 1.0, .tube = 0.3 - 1e-7}}}};
  for (const auto& [one, other] : pairs) {
    for (const double turn : {0.0, 0.3}) {
      CsgTree tree;
      const auto a = tree.add({.shape = PlacedShape(one)});
      const auto b =
          tree.add({.shape = PlacedShape(
                        other, Affine(glm::rotate(glm::dmat4(1.0), turn, glm::dvec3(0, 1, 0)))),
                    .first_face = SurfaceId{1}});
      tree.add(Operation::difference, std::array{a, b});
      CHECK(evaluate(tree).mesh.triangles.empty());
    }
  }
}

}  // namespace
}  // namespace raycat
