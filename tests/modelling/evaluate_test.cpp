#include "modelling/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/solid.hpp"
#include "geometry/tessellate.hpp"

namespace raycat {
namespace {

using Random = std::mt19937;
using NodeId = CsgTree::NodeId;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

Affine moved(const glm::dvec3& by) { return Affine(glm::translate(glm::dmat4(1.0), by)); }

PlacedShape box(const glm::dvec3& low, const glm::dvec3& high) {
  return PlacedShape(Box{.size = high - low}, moved(0.5 * (low + high)));
}

CsgTree tree_of(Operation operation, const std::vector<PlacedShape>& shapes) {
  CsgTree tree;
  std::vector<NodeId> operands;
  std::uint32_t face = 0;
  for (const PlacedShape& shape : shapes) {
    operands.push_back(tree.add({.shape = shape, .first_face = SurfaceId{face}}));
    face += shape.face_count();
  }
  tree.add(operation, operands);
  return tree;
}

double area(const EvaluatedMesh& evaluated, std::uint32_t leaf, std::uint32_t face) {
  double sum = 0.0;
  const TriangleMesh& mesh = evaluated.mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (evaluated.origins[mesh.faces[i]] == EvaluatedMesh::Origin{.leaf = leaf, .face = face}) {
      const glm::uvec3& t = mesh.triangles[i];
      sum += 0.5 * glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                          mesh.positions[t.z] - mesh.positions[t.x]));
    }
  }
  return sum;
}

PlacedShape lattice_box(Random& random) {
  glm::dvec3 low;
  glm::dvec3 size;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<double>(random() % 5);
    size[axis] = static_cast<double>(1 + random() % 3);
  }
  return box(low, low + size);
}

PlacedShape tessellated(const Shape& shape, const Affine& transform) {
  return PlacedShape(std::make_shared<const ClosedMesh>(tessellate(shape, 0.1)), transform);
}

PlacedShape mixed_shape(Random& random) {
  const glm::dvec3 at(uniform(random, 0, 5), uniform(random, 0, 5), uniform(random, 0, 5));
  const Affine turned(
      glm::rotate(glm::translate(glm::dmat4(1.0), at), uniform(random, 0, 6), glm::dvec3(1, 2, 3)));
  switch (random() % 6) {
    case 0:
      return tessellated(Sphere{.radius = uniform(random, 0.3, 1.5)}, turned);
    case 1:
      return tessellated(Torus{.radius = 1.0, .tube = uniform(random, 0.1, 0.6)}, turned);
    case 2:
      return tessellated(Cylinder{.height = 2.0, .radius_top = 0.7, .radius_bottom = 1.0}, turned);
    case 3:
      return PlacedShape(Box{.size = {2.0, 1.0, 3.0}}, turned);
    default:
      return lattice_box(random);
  }
}

CsgTree any_tree(Random& random, bool mixed, std::size_t most) {
  CsgTree tree;
  std::vector<NodeId> nodes;
  std::vector<PlacedShape> used;
  std::uint32_t face = 0;
  const std::size_t count = 1 + random() % most;
  for (std::size_t i = 0; i < count; ++i) {
    const bool again = !used.empty() && random() % 6 == 0;
    used.push_back(again   ? used[random() % used.size()]
                   : mixed ? mixed_shape(random)
                           : lattice_box(random));
    nodes.push_back(tree.add({.shape = used.back(), .first_face = SurfaceId{face}}));
    face += used.back().face_count();
  }
  while (nodes.size() > 1) {
    constexpr std::array often{Operation::set_union, Operation::set_union, Operation::difference,
                               Operation::intersection};
    const std::size_t operands = std::min<std::size_t>(nodes.size(), 2 + random() % 3);
    const auto first =
        nodes.begin() + static_cast<std::ptrdiff_t>(random() % (nodes.size() - operands + 1));
    const std::vector<NodeId> joined(first, first + static_cast<std::ptrdiff_t>(operands));
    *first = tree.add(often[random() % often.size()], joined);
    nodes.erase(first + 1, first + static_cast<std::ptrdiff_t>(operands));
  }
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

// Has the evaluated tree the solid's crossings along random rays, with the same surfaces?
struct Agreement {
  int rays = 0;
  int bad = 0;
  std::size_t crossings = 0;
};

Agreement agreement(const CsgTree& tree, Random& random, int rays) {
  Agreement out;
  const Solid solid(tree);
  const EvaluatedMesh evaluated = evaluate(tree);
  std::unique_ptr<const ClosedMesh> mesh;
  if (!evaluated.mesh.triangles.empty()) {
    mesh = std::make_unique<const ClosedMesh>(evaluated.mesh);
  }
  Solid::Scratch scratch;
  Crossings crossings;
  for (; out.rays < rays; ++out.rays) {
    const Ray ray = any_ray(random);
    solid.cross(ray, scratch);
    crossings.clear();
    if (mesh) {
      mesh->cross(ray, crossings);
    }
    bool same = crossings.size() == scratch.boundaries.size();
    for (std::size_t i = 0; same && i < crossings.size(); ++i) {
      const Boundary& expected = scratch.boundaries[i];
      same = std::abs(crossings[i].t - expected.t) * glm::length(ray.direction) < 2e-6 &&
             crossings[i].entering == expected.entering &&
             evaluated.origins[crossings[i].face] ==
                 EvaluatedMesh::Origin{.leaf = expected.leaf, .face = expected.face};
    }
    out.bad += same ? 0 : 1;
    out.crossings += crossings.size();
  }
  return out;
}

TEST_CASE("a flush slot is cut without a skin", "[modelling][evaluate]") {
  const EvaluatedMesh slot = evaluate(
      tree_of(Operation::difference, {box({0, 0, 0}, {4, 2, 4}), box({1, 1, -1}, {2, 2, 5})}));
  CHECK(signed_volume(slot.mesh) == Approx(4 * 2 * 4 - 4));
  CHECK(area(slot, 0, 3) == Approx(12));  // the top, beside the slot
  CHECK(area(slot, 0, 4) == Approx(7));   // an end
  CHECK(area(slot, 1, 2) == Approx(4));   // the slot's floor
  CHECK(area(slot, 1, 0) == Approx(4));
  CHECK(area(slot, 1, 3) == 0.0);  // where its top was there is nothing
  CHECK(slot.origins.size() == 6 + 3);
  CHECK(slot.mesh.face_count == slot.origins.size());
}

TEST_CASE("boxes that touch along an edge or at a corner are closed", "[modelling][evaluate]") {
  const glm::dvec3 by = GENERATE(glm::dvec3(1, 1, 0), glm::dvec3(1, 1, 1), glm::dvec3(1, 1, 0.5));
  const EvaluatedMesh two =
      evaluate(tree_of(Operation::set_union, {box({0, 0, 0}, {1, 1, 1}), box(by, by + 1.0)}));
  CHECK(signed_volume(two.mesh) == Approx(2.0));
  const ClosedMesh closed(two.mesh);
  CHECK(two.origins.size() == 12);
}

TEST_CASE("what comes to nothing has no triangles", "[modelling][evaluate]") {
  const auto cube = box({0, 0, 0}, {1, 1, 1});
  CHECK(evaluate(tree_of(Operation::difference, {cube, cube})).mesh.triangles.empty());
  CHECK(evaluate(tree_of(Operation::intersection, {cube, box({2, 2, 2}, {3, 3, 3})}))
            .mesh.triangles.empty());
  CHECK(evaluate(tree_of(Operation::intersection, {cube, box({1, 0, 0}, {2, 1, 1})}))
            .mesh.triangles.empty());
}

TEST_CASE("half-spaces cut, and must leave a bounded solid", "[modelling][evaluate]") {
  const PlacedShape ball(Sphere{.radius = 1.0});
  const PlacedShape below(HalfSpace{}, moved({0, 0.5, 0}));
  const EvaluatedMesh cap =
      evaluate(tree_of(Operation::difference, {ball, below}), {.chord_error = 1e-4});
  CHECK(signed_volume(cap.mesh) == Approx(3.14159265 * 0.25 * (3 - 0.5) / 3).epsilon(1e-3));
  CHECK(area(cap, 1, 0) == Approx(3.14159265 * 0.75).epsilon(1e-3));
  for (const double y : {-100.0, 100.0, -1e9, 1e9}) {
    const EvaluatedMesh all_or_nothing =
        evaluate(tree_of(Operation::intersection,
                         {box({0, 0, 0}, {1, 1, 1}), PlacedShape(HalfSpace{}, moved({0, y, 0}))}));
    CHECK(signed_volume(all_or_nothing.mesh) == Approx(y > 0 ? 1.0 : 0.0));
  }
  CHECK_THROWS_WITH(evaluate(tree_of(Operation::set_union, {ball, below})),
                    "the solid is not bounded: a half-space leaves it without end");
}

TEST_CASE("trees of lattice boxes are evaluated as rays see them", "[modelling][evaluate][tie]") {
  Random random(7);
  Agreement all;
  for (int model = 0; model < 300; ++model) {
    INFO(model);
    const Agreement one = agreement(any_tree(random, false, model % 10 == 0 ? 40 : 10), random, 60);
    CHECK(one.bad == 0);
    all.rays += one.rays;
    all.bad += one.bad;
    all.crossings += one.crossings;
  }
  CHECK(all.crossings > 5000);
  CHECK(all.bad == 0);
}

// Leaf by leaf, as a modeller does: with noise in the last bits of what was flush.
NodeId add_turned(const CsgTree& tree, const glm::dmat4& by, std::uint32_t first_face,
                  CsgTree& out) {
  std::vector<std::vector<NodeId>> operands(tree.nodes().size());
  NodeId copy{};
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    const CsgTree::Node& node = tree.nodes()[i];
    if (node.leaf == CsgTree::no_leaf) {
      copy = out.add(node.operation, operands[i]);
    } else {
      const CsgLeaf& leaf = tree.leaves()[node.leaf];
      const auto face = static_cast<std::uint32_t>(leaf.first_face);
      copy = out.add(
          {.shape = PlacedShape(leaf.shape.shape(), Affine(by * leaf.shape.transform().matrix())),
           .first_face = SurfaceId{first_face + face}});
    }
    if (node.parent != CsgTree::no_parent) {
      auto& siblings = operands[node.parent];
      siblings.insert(node.subtracted ? siblings.end() : siblings.begin(), copy);
    }
  }
  return copy;
}

glm::dmat4 any_turn(Random& random) {
  const glm::dmat4 once = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(2.5)),
                                      uniform(random, 0, 6), glm::dvec3(1, 2, 3));
  return glm::translate(glm::rotate(once, uniform(random, 0, 6), glm::dvec3(-3, 1, 1)),
                        glm::dvec3(-2.5));
}

TEST_CASE("what is flush but for rounding leaves no skin", "[modelling][evaluate][tie]") {
  Random random(9);
  std::size_t crossings = 0;
  std::size_t plain_triangles = 0;
  std::size_t turned_triangles = 0;
  for (int model = 0; model < 40; ++model) {
    INFO(model);
    const CsgTree plain = any_tree(random, false, 10);
    CsgTree tree;
    add_turned(plain, any_turn(random), 0, tree);
    const Agreement one = agreement(tree, random, 60);
    CHECK(one.bad == 0);
    crossings += one.crossings;
    const EvaluatedMesh a = evaluate(plain);
    const EvaluatedMesh b = evaluate(tree);
    CHECK(signed_volume(a.mesh) == Approx(signed_volume(b.mesh)).margin(1e-6));
    CHECK(a.origins == b.origins);
    for (const EvaluatedMesh::Origin& origin : a.origins) {
      CHECK(area(a, origin.leaf, origin.face) ==
            Approx(area(b, origin.leaf, origin.face)).margin(1e-6));
    }
    plain_triangles += a.mesh.triangles.size();
    turned_triangles += b.mesh.triangles.size();
  }
  CHECK(crossings > 500);
  CHECK(turned_triangles < plain_triangles * 12 / 10);
}

TEST_CASE("parts that are turned each in its own way leave no skin", "[modelling][evaluate][tie]") {
  Random random(10);
  std::size_t crossings = 0;
  for (int model = 0; model < 15; ++model) {
    INFO(model);
    CsgTree tree;
    const CsgTree first = any_tree(random, false, 6);
    const auto faces = static_cast<std::uint32_t>(6 * first.leaves().size());
    const NodeId a = add_turned(first, any_turn(random), 0, tree);
    const NodeId b = add_turned(any_tree(random, false, 6), any_turn(random), faces, tree);
    tree.add(model % 2 == 0 ? Operation::set_union : Operation::difference, std::array{a, b});
    const Agreement one = agreement(tree, random, 60);
    CHECK(one.bad == 0);
    crossings += one.crossings;
  }
  CHECK(crossings > 200);
}

TEST_CASE("trees of turned and curved operands are evaluated as rays see them",
          "[modelling][evaluate][tie]") {
  Random random(8);
  Agreement all;
  for (int model = 0; model < 60; ++model) {
    INFO(model);
    const Agreement one = agreement(any_tree(random, true, 12), random, 60);
    CHECK(one.bad == 0);
    all.crossings += one.crossings;
  }
  CHECK(all.crossings > 1000);
}

TEST_CASE("shells of one mesh that overlap are united", "[modelling][evaluate]") {
  TriangleMesh shells = tessellate(Box{.size = glm::dvec3(2.0)}, 0.0);
  TriangleMesh second = shells;
  for (const glm::dvec3& position : second.positions) {
    shells.positions.push_back(position + 1.0);
  }
  for (std::size_t i = 0; i < second.triangles.size(); ++i) {
    shells.triangles.push_back(second.triangles[i] + 8U);
    shells.faces.push_back(second.faces[i]);
  }
  const EvaluatedMesh united = evaluate(tree_of(
      Operation::set_union, {PlacedShape(std::make_shared<const ClosedMesh>(std::move(shells)))}));
  CHECK(signed_volume(united.mesh) == Approx(8 + 8 - 1));
}

TEST_CASE("a chain of 1000 operations is evaluated", "[modelling][evaluate]") {
  CsgTree tree;
  NodeId chain = tree.add({.shape = box({0, 0, 0}, {1001, 2, 2})});
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const NodeId next = tree.add(
        {.shape = box({i + 0.25, 1, 0.5}, {i + 0.75, 2, 1.5}), .first_face = SurfaceId{6 * i + 6}});
    chain = tree.add(Operation::difference, std::array{chain, next});
  }
  CHECK(signed_volume(evaluate(tree).mesh) == Approx(1001 * 4 - 1000 * 0.5));
}

}  // namespace
}  // namespace raycat
