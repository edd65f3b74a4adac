// Two surfaces a gap apart: within the tolerance they are one from every side, beyond it they are
// two from every side.

#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/coincident_leaves.hpp"
#include "csg/solid.hpp"
#include "geometry/tessellate.hpp"
#include "tests/csg/random_models.hpp"

namespace raycat {
namespace {

// What has a skin or a slit as thick as the gap at a point, across the normal there.
struct Case {
  std::string name;
  std::function<Model(double)> model;
  glm::dvec3 point;
  glm::dvec3 normal;
};

PlacedShape at(Shape shape, const glm::dvec3& place) {
  return PlacedShape(std::move(shape), placed(place));
}

Shape mesh_of(const Box& box) { return std::make_shared<const ClosedMesh>(box_mesh(box.size)); }

std::vector<Case> cases() {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 floor(0.1, -0.5, 0.2);
  const glm::dvec3 side(0.6, 0.0, 0.8);
  const Box slab{.size = {4, 1, 4}};
  const Box plug{.size = {2, 2, 2}};
  const auto minus = [](PlacedShape a, PlacedShape b) {
    return two(Operation::difference, std::move(a), std::move(b));
  };
  const auto on = [](PlacedShape a, PlacedShape b) {
    return two(Operation::set_union, std::move(a), std::move(b));
  };
  // A hole as deep as the slab but for the gap.
  const auto hole = [=](const Shape& one, const Shape& other) {
    return [=](double gap) { return minus(at(one, {}), at(other, {0, 0.5 + gap, 0})); };
  };
  const auto tower = [=](const Shape& one, const Shape& other) {
    return [=](double gap) { return on(at(one, {}), at(other, {0, 1.5 + gap, 0})); };
  };
  const double slope = std::hypot(1.0, 0.25);
  return {
      {"box in box", hole(slab, plug), floor, up},
      {"cylinder in box", hole(slab, Cylinder{.height = 2, .radius_top = 1, .radius_bottom = 0.8}),
       floor, up},
      {"box in cylinder", hole(Cylinder{.height = 1, .radius_top = 2, .radius_bottom = 2}, plug),
       floor, up},
      {"box in mesh", hole(mesh_of(slab), plug), floor, up},
      {"mesh in box", hole(slab, mesh_of(plug)), floor, up},
      {"mesh in mesh", hole(mesh_of(slab), mesh_of(plug)), floor, up},
      {"half-space from box",
       [=](double gap) {
         const glm::dmat4 over = glm::rotate(glm::translate(glm::dmat4(1.0), {0, -0.5 + gap, 0}),
                                             M_PI, glm::dvec3(1, 0, 0));
         return minus(at(slab, {}), PlacedShape(HalfSpace{}, Affine(over)));
       },
       floor, up},
      {"box on box", tower(slab, plug), {0.1, 0.5, 0.2}, up},
      {"mesh on box", tower(slab, mesh_of(plug)), {0.1, 0.5, 0.2}, up},
      {"ball in ball",
       [=](double gap) { return minus(at(Sphere{1.0 + gap}, {}), at(Sphere{1.0}, {})); },
       {0.6, 0.48, 0.64},
       {0.6, 0.48, 0.64}},
      {"cylinder in cylinder",
       [=](double gap) {
         return minus(at(Cylinder{2.0, 1.0 + gap, 1.0 + gap}, {}), at(Cylinder{3.0, 1.0, 1.0}, {}));
       },
       side, side},
      {"cylinder in capsule",
       [=](double gap) {
         return minus(at(Capsule{2.0, 1.0 + gap, 1.0 + gap}, {}), at(Cylinder{1.5, 1.0, 1.0}, {}));
       },
       side, side},
      {"cone in cone",
       [=](double gap) {
         const double less = gap * slope;
         return minus(at(Cylinder{2.0, 0.5, 1.0}, {}),
                      at(Cylinder{4.0, 0.25 - less, 1.25 - less}, {}));
       },
       0.75 * side, glm::normalize(glm::dvec3(0.6, 0.25, 0.8))},
      {"ring in ring",
       [=](double gap) {
         return minus(at(Torus{1.0, 0.25 + gap}, {}), at(Torus{1.0, 0.25}, {}));
       },
       1.25 * side, side},
  };
}

Model moved(Model model, const glm::dmat4& map) {
  for (CsgLeaf& leaf : model.leaves) {
    leaf.shape = PlacedShape(leaf.shape.shape(), Affine(map * leaf.shape.transform().matrix()));
  }
  return model;
}

bool same(const std::vector<Boundary>& a, const std::vector<Boundary>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.t == y.t && x.leaf == y.leaf && x.piece == y.piece && x.entering == y.entering;
  });
}

TEST_CASE("what is seen of a gap depends on its width alone", "[csg][flush]") {
  Random random(11);
  Solid::Scratch scratch;
  // Of the tolerance, which is 1e-7 of the half diagonal.
  constexpr std::array widths{0.01, 0.1, 0.5, 0.9, 0.99, 1.01, 1.1, 2.0, 10.0, 100.0};
  for (const double scale : {1.0, 1e-3, 2e4}) {
    for (const bool plain : {true, false}) {
      glm::dmat4 map = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
      if (!plain) {
        const glm::dvec3 axis(uniform(random, -1, 1), uniform(random, -1, 1), 1.0);
        map = glm::translate(glm::dmat4(1.0), scale * glm::dvec3(3, -5, 2)) *
              glm::rotate(map, uniform(random, 0, 6), glm::normalize(axis)) *
              glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
      }
      for (const Case& one : cases()) {
        const double tolerance =
            coincidence_tolerance(bounded_leaves(tree_of(moved(one.model(0.0), map)))) / scale;
        for (const double width : widths) {
          for (const double sign : {1.0, -1.0}) {
            const Solid solid = solid_of(moved(one.model(sign * width * tolerance), map));
            const std::size_t expected = sign * width > 1.0 ? 2 : 0;
            const glm::dvec3 normal = glm::normalize(glm::dmat3(map) * one.normal);
            const glm::dvec3 point(map * glm::dvec4(one.point, 1.0));
            int wrong = 0;
            int steps_wrong = 0;
            int first_wrong = 0;
            for (int direction = 0; direction < 200; ++direction) {
              const glm::dvec3 way = glm::normalize(glm::dvec3(
                  uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)));
              if (std::abs(glm::dot(way, normal)) < 0.03) {
                continue;
              }
              const Ray ray{.origin = point - uniform(random, 0.1, 9.0) * scale * way,
                            .direction = uniform(random, 0.5, 2) * way};
              solid.cross(ray, scratch);
              const std::vector<Boundary> all = scratch.boundaries;
              std::size_t near = 0;
              for (const Boundary& boundary : all) {
                const double away = glm::length(ray.at(boundary.t) - point);
                near += away < 1e-2 * scale ? 1 : 0;
              }
              wrong += near == expected ? 0 : 1;
              std::vector<Boundary> stepped;
              for (auto next = solid.first(ray, -INFINITY, INFINITY, scratch); next;
                   next = solid.next(scratch)) {
                stepped.push_back(*next);
              }
              steps_wrong += same(stepped, all) ? 0 : 1;
              // From the ray's origin on, as a camera sees it.
              std::vector<Boundary> ahead;
              std::ranges::copy_if(all, std::back_inserter(ahead),
                                   [](const Boundary& b) { return b.t > 0.0; });
              const auto first = solid.first(ray, 0.0, INFINITY, scratch);
              first_wrong +=
                  first ? (!ahead.empty() && first->t == ahead.front().t ? 0 : 1) : !ahead.empty();
            }
            CAPTURE(one.name, scale, plain, sign * width);
            CHECK(wrong == 0);
            CHECK(steps_wrong == 0);
            CHECK(first_wrong == 0);
          }
        }
      }
    }
  }
}

TEST_CASE("a tray's thin floor is all there or not at all", "[csg][flush]") {
  // As thick as 0.7 of the tolerance, and as 1.4 of it.
  for (const double thickness : {5e-6, 1e-5}) {
    const Model tray = two(Operation::difference, PlacedShape(Box{.size = {100, 100, 1}}),
                           PlacedShape(Box{.size = {90, 90, 2}}, placed({0, 0, 0.5 + thickness})));
    const Solid solid = solid_of(tray);
    Solid::Scratch scratch;
    int seen = 0;
    int rays = 0;
    for (double x = -44.0; x <= 44.0; x += 4.0) {
      for (double y = -44.0; y <= 44.0; y += 4.0, ++rays) {
        const glm::dvec3 eye(0, 0, 20);
        seen += solid.first({.origin = eye, .direction = glm::dvec3(x, y, -0.5) - eye}, 0.0,
                            INFINITY, scratch)
                    ? 1
                    : 0;
      }
    }
    CHECK(seen == (thickness > 7.1e-6 ? rays : 0));
  }
}

TEST_CASE("a plate thinner than the tolerance is not there, and one alone is", "[csg][flush]") {
  const PlacedShape plate(Box{.size = {2, 1e-8, 2}}, placed({}, 0.4));
  Model alone;
  add_leaf(alone, plate);
  Solid::Scratch scratch;
  const Ray ray{.origin = {0.1, 3, 0.2}, .direction = {0.1, -1, 0.2}};
  solid_of(alone).cross(ray, scratch);
  CHECK(scratch.boundaries.size() == 2);
  solid_of(two(Operation::set_union, plate, at(Sphere{}, {5, 0, 0}))).cross(ray, scratch);
  CHECK(scratch.boundaries.empty());
}

}  // namespace
}  // namespace raycat
