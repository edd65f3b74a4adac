#include "csg/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <rapidcheck.h>

namespace raycat {
namespace {

// A CSG expression as a person would write it, and the oracle: is a point in the set?
struct Expression {
  Operation operation = Operation::set_union;
  std::vector<Expression> operands;  // none: a leaf
  std::uint32_t leaf = 0;
};

struct Model {
  Expression expression;
  std::vector<CsgLeaf> leaves;
};

// Is a point inside a leaf? By the definition of each shape, not by its crossings.
bool contains(const CsgLeaf& leaf, const glm::dvec3& world) {
  const Affine& transform = leaf.shape.transform();
  const glm::dvec3 p = transform.to_local({.origin = world, .direction = {1, 0, 0}}).origin;
  if (const auto* sphere = std::get_if<Sphere>(&leaf.shape.shape())) {
    return glm::length(p) < sphere->radius;
  }
  if (const auto* box = std::get_if<Box>(&leaf.shape.shape())) {
    return std::abs(p.x) < box->size.x / 2 && std::abs(p.y) < box->size.y / 2 &&
           std::abs(p.z) < box->size.z / 2;
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&leaf.shape.shape())) {
    return std::abs(p.y) < cylinder->height / 2 && std::hypot(p.x, p.z) < cylinder->radius_top;
  }
  return p.y < 0.0;
}

bool contains(const Expression& e, const std::vector<CsgLeaf>& leaves, const glm::dvec3& p) {
  if (e.operands.empty()) {
    return contains(leaves[e.leaf], p);
  }
  const auto in = [&](const Expression& operand) { return contains(operand, leaves, p); };
  switch (e.operation) {
    case Operation::set_union:
      return std::ranges::any_of(e.operands, in);
    case Operation::intersection:
      return std::ranges::all_of(e.operands, in);
    case Operation::difference:
      return in(e.operands.front()) && std::none_of(e.operands.begin() + 1, e.operands.end(), in);
  }
  return false;
}

CsgTree::NodeId build(CsgTree& tree, const Expression& e, const std::vector<CsgLeaf>& leaves) {
  if (e.operands.empty()) {
    return tree.add(leaves[e.leaf]);
  }
  std::vector<CsgTree::NodeId> ids;
  for (const Expression& operand : e.operands) {
    ids.push_back(build(tree, operand, leaves));
  }
  return tree.add(e.operation, ids);
}

Solid solid_of(const Model& model) {
  CsgTree tree;
  build(tree, model.expression, model.leaves);
  return Solid(std::move(tree));
}

Affine placed(const glm::dvec3& at, double turn = 0.0) {
  return Affine(glm::rotate(glm::translate(glm::dmat4(1.0), at), turn, glm::dvec3(1, 2, 3)));
}

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

// Face ids follow one another leaf by leaf.
void add_leaf(Model& model, PlacedShape shape) {
  std::uint32_t next = 0;
  if (!model.leaves.empty()) {
    const CsgLeaf& last = model.leaves.back();
    next = static_cast<std::uint32_t>(last.first_face) + last.shape.face_count();
  }
  model.leaves.push_back({.shape = std::move(shape), .first_face = SurfaceId{next}});
}

PlacedShape any_shape(Random& random) {
  const glm::dvec3 at(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  const Affine transform = placed(at, uniform(random, 0, 3));
  switch (random() % 4) {
    case 0:
      return PlacedShape(Sphere{.radius = uniform(random, 0.3, 1.2)}, transform);
    case 1: {
      const double r = uniform(random, 0.2, 0.8);
      return PlacedShape(
          Cylinder{.height = uniform(random, 0.5, 2), .radius_top = r, .radius_bottom = r},
          transform);
    }
    case 2:
      return PlacedShape(HalfSpace{}, transform);
    default:
      return PlacedShape(
          Box{.size = {uniform(random, 0.3, 2), uniform(random, 0.3, 2), uniform(random, 0.3, 2)}},
          transform);
  }
}

PlacedShape integer_box(Random& random) {
  glm::dvec3 low;
  glm::dvec3 high;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<int>(random() % 5);
    low[axis] = a;
    high[axis] = a + 1 + static_cast<int>(random() % 3);
  }
  return PlacedShape(Box{.size = high - low},
                     Affine(glm::translate(glm::dmat4(1.0), 0.5 * (low + high))));
}

Expression any_expression(Random& random, Model& model, int depth,
                          const std::function<PlacedShape(Random&)>& shape) {
  if (depth == 0 || random() % 4 == 0) {
    add_leaf(model, shape(random));
    return {.leaf = static_cast<std::uint32_t>(model.leaves.size() - 1)};
  }
  Expression e{.operation = static_cast<Operation>(random() % 3)};
  const std::size_t operands = 2 + random() % 2;
  for (std::size_t i = 0; i < operands; ++i) {
    e.operands.push_back(any_expression(random, model, depth - 1, shape));
  }
  return e;
}

Model any_model(unsigned seed, const std::function<PlacedShape(Random&)>& shape) {
  Random random(seed);
  Model model;
  model.expression = any_expression(random, model, 3, shape);
  return model;
}

Ray any_ray(Random& random) {
  const glm::dvec3 from(uniform(random, -3, 6), uniform(random, -3, 6), uniform(random, -3, 6));
  const glm::dvec3 to(uniform(random, -1, 3), uniform(random, -1, 3), uniform(random, -1, 3));
  return {.origin = from, .direction = to - from};
}

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

// The same set with its operands in another order. Differences keep their first.
void shuffle(Expression& e, Random& random) {
  const auto begin = e.operands.begin() + (e.operation == Operation::difference ? 1 : 0);
  if (!e.operands.empty()) {
    std::shuffle(begin, e.operands.end(), random);
  }
  for (Expression& operand : e.operands) {
    shuffle(operand, random);
  }
}

std::vector<std::pair<double, SurfaceId>> surfaces(const Solid& solid, const Ray& ray) {
  Solid::Scratch scratch;
  solid.cross(ray, scratch);
  std::vector<std::pair<double, SurfaceId>> found;
  for (const Boundary& boundary : scratch.boundaries) {
    found.emplace_back(boundary.t, solid.surface(boundary));
  }
  return found;
}

// Boxes on an integer lattice have flush faces everywhere, so ties are the rule.
TEST_CASE("ids do not depend on the order of operands", "[csg][solid][tie]") {
  CHECK(rc::check("shuffles", [](unsigned seed) {
    Model model = any_model(seed, integer_box);
    const Solid solid = solid_of(model);
    Random random(seed);
    shuffle(model.expression, random);
    const Solid shuffled = solid_of(model);
    for (int i = 0; i < 30; ++i) {
      const Ray ray = any_ray(random);
      RC_ASSERT(surfaces(solid, ray) == surfaces(shuffled, ray));
    }
  }));
}

TEST_CASE("ids do not depend on a rigid motion", "[csg][solid][tie]") {
  CHECK(rc::check("motions", [](unsigned seed) {
    const Model model = any_model(seed, integer_box);
    Random random(seed);
    const glm::dmat4 motion =
        glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(uniform(random, -9, 9), 2, 1)),
                    uniform(random, 0, 6), glm::normalize(glm::dvec3(1, uniform(random, 0, 1), 2)));
    Model moved = model;
    for (CsgLeaf& leaf : moved.leaves) {
      leaf.shape =
          PlacedShape(leaf.shape.shape(), Affine(motion * leaf.shape.transform().matrix()));
    }
    const Solid here = solid_of(model);
    const Solid there = solid_of(moved);
    for (int i = 0; i < 30; ++i) {
      const Ray ray = any_ray(random);
      const Ray moved_ray{.origin = glm::dvec3(motion * glm::dvec4(ray.origin, 1.0)),
                          .direction = glm::dmat3(motion) * ray.direction};
      const auto a = surfaces(here, ray);
      const auto b = surfaces(there, moved_ray);
      RC_ASSERT(a.size() == b.size());
      for (std::size_t k = 0; k < a.size(); ++k) {
        RC_ASSERT(a[k].second == b[k].second);
        RC_ASSERT(std::abs(a[k].first - b[k].first) < 1e-9);
      }
    }
  }));
}

Model two(Operation operation, PlacedShape a, PlacedShape b) {
  Model model;
  add_leaf(model, std::move(a));
  add_leaf(model, std::move(b));
  model.expression = {.operation = operation, .operands = {{.leaf = 0}, {.leaf = 1}}};
  return model;
}

TEST_CASE("a flush difference leaves no skin", "[csg][solid][tie]") {
  // The cutter's top is the box's own top: a slot open upwards.
  const Model slot = two(Operation::difference, PlacedShape(Box{.size = {4, 2, 4}}, placed({})),
                         PlacedShape(Box{.size = {1, 1, 6}}, placed({0, 0.5, 0})));
  const auto found = surfaces(solid_of(slot), {.origin = {0.2, 5, 0.1}, .direction = {0, -1, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].first == Approx(5.0));        // the slot's floor, at y = 0
  CHECK(found[0].second == SurfaceId{6 + 2});  // the cutter's lower face
  CHECK(found[1].first == Approx(6.0));
  CHECK(found[1].second == SurfaceId{2});  // the box's lower face
}

TEST_CASE("identical operands are one solid with the first one's ids", "[csg][solid][tie]") {
  const auto box = [] { return PlacedShape(Box{.size = {2, 2, 2}}, placed({})); };
  const Ray ray{.origin = {-5, 0.3, 0.2}, .direction = {2, 0, 0}};
  using Found = std::vector<std::pair<double, SurfaceId>>;
  const Found first{{2.0, SurfaceId{0}}, {3.0, SurfaceId{1}}};
  CHECK(surfaces(solid_of(two(Operation::set_union, box(), box())), ray) == first);
  CHECK(surfaces(solid_of(two(Operation::intersection, box(), box())), ray) == first);
  CHECK(surfaces(solid_of(two(Operation::difference, box(), box())), ray).empty());
}

TEST_CASE("faces that touch from both sides vanish in a union", "[csg][solid][tie]") {
  const Model halves = two(Operation::set_union, PlacedShape(Box{.size = {1, 1, 1}}, placed({})),
                           PlacedShape(Box{.size = {1, 1, 1}}, placed({1, 0, 0})));
  const auto found = surfaces(solid_of(halves), {.origin = {-3, 0.1, 0.1}, .direction = {1, 0, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].second == SurfaceId{0});
  CHECK(found[1].second == SurfaceId{6 + 1});
}

TEST_CASE("a subtracted surface is reported only where no kept one is", "[csg][solid][tie]") {
  // Intersected, the first box and the complement of the second share the plane x = 0: the kept
  // box's face is the responsible one.
  const Model cut =
      two(Operation::difference, PlacedShape(Box{.size = {2, 2, 2}}, placed({1, 0, 0})),
          PlacedShape(Box{.size = {2, 4, 4}}, placed({-1, 0, 0})));
  const auto found = surfaces(solid_of(cut), {.origin = {-5, 0.1, 0}, .direction = {1, 0, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].second == SurfaceId{0});
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
