#include "tests/csg/random_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace raycat {
namespace {

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

}  // namespace

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

CsgTree tree_of(const Model& model) {
  CsgTree tree;
  build(tree, model.expression, model.leaves);
  return tree;
}

Solid solid_of(const Model& model) { return Solid(tree_of(model)); }

Affine placed(const glm::dvec3& at, double turn) {
  return Affine(glm::rotate(glm::translate(glm::dmat4(1.0), at), turn, glm::dvec3(1, 2, 3)));
}

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

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

Model two(Operation operation, PlacedShape a, PlacedShape b) {
  Model model;
  add_leaf(model, std::move(a));
  add_leaf(model, std::move(b));
  model.expression = {.operation = operation, .operands = {{.leaf = 0}, {.leaf = 1}}};
  return model;
}

TriangleMesh box_mesh(const glm::dvec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back(
        0.5 * size *
        glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.faces.push_back(std::array{4u, 5u, 2u, 3u, 0u, 1u}[i / 2]);
  }
  mesh.face_count = 6;
  return mesh;
}

}  // namespace raycat
