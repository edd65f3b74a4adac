// Large and awkward trees against the plain evaluation, which looks at every leaf.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/solid.hpp"
#include "tests/csg/linear_solid.hpp"

namespace raycat {
namespace {

using Random = std::mt19937;
using NodeId = CsgTree::NodeId;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

Affine moved(const glm::dvec3& by) { return Affine(glm::translate(glm::dmat4(1.0), by)); }

enum class Leaves { lattice, mixed };
enum class Form { left_deep, right_deep, balanced, flat, any };

// Boxes on an integer lattice have flush faces everywhere, and identical operands often.
PlacedShape lattice_box(Random& random) {
  glm::dvec3 low;
  glm::dvec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<double>(random() % 5);
    size[axis] = static_cast<double>(1 + random() % 3);
  }
  return PlacedShape(Box{.size = size}, moved(low + 0.5 * size));
}

PlacedShape mixed_shape(Random& random) {
  const glm::dvec3 at(uniform(random, 0, 5), uniform(random, 0, 5), uniform(random, 0, 5));
  switch (random() % 8) {
    case 0:
      return PlacedShape(HalfSpace{},
                         Affine(glm::rotate(glm::translate(glm::dmat4(1.0), at),
                                            uniform(random, 0, 6), glm::dvec3(1, 2, 3))));
    case 1:
    case 2:
      return PlacedShape(Sphere{.radius = uniform(random, 0.3, 1.5)}, moved(at));
    case 3:
      return PlacedShape(Torus{.radius = 1.0, .tube = uniform(random, 0.1, 0.6)}, moved(at));
    default:
      return lattice_box(random);
  }
}

struct Maker {
  Random& random;
  CsgTree& tree;
  Leaves leaves;
  std::vector<PlacedShape> used;
  std::uint32_t next_face = 0;

  NodeId leaf() {
    const bool again = !used.empty() && random() % 6 == 0;  // a shared operand: ids of its own
    PlacedShape shape = again                     ? used[random() % used.size()]
                        : leaves == Leaves::mixed ? mixed_shape(random)
                                                  : lattice_box(random);
    used.push_back(shape);
    const SurfaceId first{next_face};
    next_face += shape.face_count();
    return tree.add({.shape = std::move(shape), .first_face = first});
  }

  Operation operation() {
    constexpr std::array often{Operation::set_union, Operation::set_union, Operation::difference,
                               Operation::intersection};
    return often[random() % often.size()];
  }

  // Joins neighbours until one is left.
  NodeId join(std::vector<NodeId> nodes, Form form) {
    if (form == Form::flat) {
      return tree.add(operation(), nodes);
    }
    while (nodes.size() > 1) {
      const std::size_t count = std::min<std::size_t>(nodes.size(), 2 + random() % 3);
      const std::size_t at = form == Form::left_deep    ? 0
                             : form == Form::right_deep ? nodes.size() - count
                                                        : random() % (nodes.size() - count + 1);
      if (form == Form::balanced) {
        std::vector<NodeId> above;
        for (std::size_t i = 0; i < nodes.size(); i += 2) {
          const std::size_t end = std::min(i + 2, nodes.size());
          const std::vector<NodeId> pair(nodes.begin() + static_cast<std::ptrdiff_t>(i),
                                         nodes.begin() + static_cast<std::ptrdiff_t>(end));
          above.push_back(tree.add(operation(), pair));
        }
        nodes = above;
        continue;
      }
      const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(at);
      const std::vector<NodeId> operands(first, first + static_cast<std::ptrdiff_t>(count));
      *first = tree.add(operation(), operands);
      nodes.erase(first + 1, first + static_cast<std::ptrdiff_t>(count));
    }
    return nodes.front();
  }
};

CsgTree any_tree(Random& random, Leaves leaves, Form form) {
  CsgTree tree;
  Maker maker{.random = random, .tree = tree, .leaves = leaves, .used = {}};
  const std::size_t count = 2 + random() % (random() % 4 == 0 ? 150 : 12);
  std::vector<NodeId> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    nodes.push_back(maker.leaf());
  }
  maker.join(nodes, form);
  return tree;
}

Ray any_ray(Random& random) {
  const glm::dvec3 to(uniform(random, 0, 6), uniform(random, 0, 6), uniform(random, 0, 6));
  glm::dvec3 direction(0.0);
  if (random() % 3 == 0) {
    direction[static_cast<int>(random() % 3)] = random() % 2 == 0 ? 2.0 : -0.5;
  } else {
    direction = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  }
  return {.origin = to - uniform(random, -1, 5) * direction, .direction = direction};
}

bool same(const Boundary& a, const Boundary& b) {
  return a.t == b.t && a.leaf == b.leaf && a.face == b.face && a.piece == b.piece &&
         a.entering == b.entering && a.subtracted == b.subtracted && a.normal == b.normal;
}

std::vector<Boundary> between(const std::vector<Boundary>& all, double begin, double end) {
  std::vector<Boundary> found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [&](const Boundary& b) { return b.t > begin && b.t < end; });
  return found;
}

std::vector<Boundary> one_by_one(const Solid& solid, const Ray& ray, double begin, double end,
                                 Solid::Scratch& scratch) {
  std::vector<Boundary> found;
  for (auto next = solid.first(ray, begin, end, scratch); next; next = solid.next(scratch)) {
    found.push_back(*next);
  }
  return found;
}

TEST_CASE("a solid has the boundaries of the plain evaluation", "[csg][scale][tie]") {
  Random random(20);
  Solid::Scratch scratch;
  LinearSolid::Scratch plain;
  int rays = 0;
  int bad = 0;
  int bad_steps = 0;
  std::size_t boundaries = 0;
  for (int model = 0; model < 6000; ++model) {
    const CsgTree tree = any_tree(random, model % 2 == 0 ? Leaves::lattice : Leaves::mixed,
                                  static_cast<Form>(random() % 5));
    const Solid solid(tree);
    const LinearSolid oracle(tree);
    for (int i = 0; i < 40; ++i, ++rays) {
      const Ray ray = any_ray(random);
      const bool inside = oracle.cross(ray, plain);
      boundaries += plain.boundaries.size();
      if (solid.cross(ray, scratch) != inside ||
          !std::ranges::equal(scratch.boundaries, plain.boundaries, same)) {
        ++bad;
      }
      // Often from a boundary on, where crossings of the same group lie just behind.
      double begin = 0.0;
      if (!plain.boundaries.empty() && random() % 2 == 0) {
        begin = plain.boundaries[random() % plain.boundaries.size()].t + 1e-9;
      }
      const double end = random() % 2 == 0 ? INFINITY : begin + uniform(random, 0, 3);
      if (!std::ranges::equal(one_by_one(solid, ray, begin, end, scratch),
                              between(plain.boundaries, begin, end), same)) {
        ++bad_steps;
      }
    }
  }
  CAPTURE(rays, boundaries);
  CHECK(rays == 240'000);
  CHECK(boundaries > 100'000);
  CHECK(bad == 0);
  CHECK(bad_steps == 0);
}

TEST_CASE("a scratch serves solids in turn", "[csg][scale]") {
  Random random(4);
  const Solid a(any_tree(random, Leaves::lattice, Form::left_deep));
  const Solid b(any_tree(random, Leaves::mixed, Form::balanced));
  Solid::Scratch shared;
  for (int i = 0; i < 500; ++i) {
    const Ray ray = any_ray(random);
    for (const Solid* solid : {&a, &b}) {
      Solid::Scratch fresh;
      solid->cross(ray, fresh);
      solid->cross(ray, shared);
      REQUIRE(std::ranges::equal(shared.boundaries, fresh.boundaries, same));
    }
  }
}

TEST_CASE("a chain of a million differences is traced", "[csg][scale]") {
  // A bar from 0 to 1 000 000 cut at every odd unit: half a million pieces.
  constexpr int cuts = 1'000'000;
  CsgTree tree;
  NodeId node =
      tree.add({.shape = PlacedShape(Box{.size = {1.0 * cuts, 2, 2}}, moved({0.5 * cuts, 0, 0}))});
  for (int i = 0; i < cuts; ++i) {
    const SurfaceId first{static_cast<std::uint32_t>(6 + 6 * i)};
    const NodeId cutter =
        tree.add({.shape = PlacedShape(Box{.size = {0.5, 3, 3}}, moved({i + 0.5, 0, 0})),
                  .first_face = first});
    node = tree.add(Operation::difference, std::array{node, cutter});
  }
  const Solid solid(std::move(tree));
  Solid::Scratch scratch;
  solid.cross({.origin = {250'000.5, -5, 0.1}, .direction = {0, 1, 0}}, scratch);
  CHECK(scratch.boundaries.empty());
  solid.cross({.origin = {250'000.1, -5, 0.1}, .direction = {0, 1, 0}}, scratch);
  CHECK(scratch.boundaries.size() == 2);
  const Ray along{.origin = {500'000.5, 0.2, 0.1}, .direction = {1, 0, 0}};
  const std::optional<Boundary> next = solid.first(along, 0.0, 10.0, scratch);
  REQUIRE(next);
  CHECK(next->t == Approx(0.25));
  CHECK(next->subtracted);
  CHECK(next->entering);
  CHECK(solid.surface(*next) == SurfaceId{6 + 6 * 500'000 + 1});
  solid.cross(along, scratch);
  CHECK(scratch.boundaries.size() == 2 + 2 * cuts);
}

}  // namespace
}  // namespace raycat
