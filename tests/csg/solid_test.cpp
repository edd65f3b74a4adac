#include "csg/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <rapidcheck.h>

#include "tests/csg/random_models.hpp"

namespace raycat {
namespace {

TEST_CASE("boundaries lie exactly where membership changes, on random trees", "[csg][solid]") {
  CHECK(rc::check("membership between crossings", [](unsigned seed) {
    const Model model = any_model(seed, any_shape);
    const Solid solid = solid_of(model);
    Random random(seed + 1);
    Solid::Scratch scratch;
    for (int i = 0; i < 20; ++i) {
      const Ray ray = any_ray(random);
      bool inside = solid.cross(ray, scratch);

      // Every leaf's crossings cut the line; membership is constant in between.
      std::vector<double> cuts{-1e3, 1e3};
      for (const CsgLeaf& leaf : model.leaves) {
        Crossings crossings;
        leaf.shape.cross(ray, crossings);
        for (const Crossing& crossing : crossings) {
          cuts.push_back(crossing.t);
        }
      }
      std::ranges::sort(cuts);
      std::size_t next = 0;
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        while (next < scratch.boundaries.size() && scratch.boundaries[next].t <= cuts[k]) {
          RC_ASSERT(scratch.boundaries[next].entering != inside);
          inside = scratch.boundaries[next].entering;
          ++next;
        }
        if (cuts[k + 1] - cuts[k] > 1e-5) {
          const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
          RC_ASSERT(contains(model.expression, model.leaves, ray.at(middle)) == inside);
        }
      }
    }
  }));
}

TEST_CASE("a boundary's normal points out of the final solid", "[csg][solid]") {
  CHECK(rc::check("normals", [](unsigned seed) {
    const Solid solid = solid_of(any_model(seed, any_shape));
    Random random(seed);
    Solid::Scratch scratch;
    for (int i = 0; i < 20; ++i) {
      const Ray ray = any_ray(random);
      solid.cross(ray, scratch);
      for (const Boundary& boundary : scratch.boundaries) {
        const glm::dvec3 normal = solid.normal(boundary);
        RC_ASSERT(std::abs(glm::length(normal) - 1.0) < 1e-12);
        const double facing = glm::dot(normal, glm::normalize(ray.direction));
        RC_ASSERT((boundary.entering ? facing < 1e-9 : facing > -1e-9));
      }
    }
  }));
}

TEST_CASE("a ball minus a half-space is half a ball", "[csg][solid]") {
  const Solid half = solid_of(
      two(Operation::difference, PlacedShape(Sphere{.radius = 1.0}), PlacedShape(HalfSpace{})));
  Solid::Scratch scratch;
  CHECK_FALSE(half.cross({.origin = {0, 3, 0}, .direction = {0, -1, 0}}, scratch));
  REQUIRE(scratch.boundaries.size() == 2);
  CHECK(scratch.boundaries[0].t == Approx(2.0));
  CHECK(scratch.boundaries[1].t == Approx(3.0));
  CHECK(scratch.boundaries[1].subtracted);
  CHECK(half.normal(scratch.boundaries[1]) == glm::dvec3(0, -1, 0));
  CHECK(half.bounds().min.x == Approx(-1.0));
}

TEST_CASE("the inside of a half-space reaches to infinity", "[csg][solid]") {
  CsgTree tree;
  tree.add({.shape = PlacedShape(HalfSpace{})});
  const Solid ground(std::move(tree));
  Solid::Scratch scratch;
  CHECK(ground.cross({.origin = {0, -1, 0}, .direction = {1, 0, 0}}, scratch));
  CHECK(scratch.boundaries.empty());
  CHECK_FALSE(ground.cross({.origin = {0, 1, 0}, .direction = {1, 0, 0}}, scratch));
  CHECK_FALSE(ground.bounds().finite());
}

}  // namespace
}  // namespace raycat
