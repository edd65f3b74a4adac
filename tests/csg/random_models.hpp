#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "csg/solid.hpp"
#include "csg/tree.hpp"
#include "geometry/mesh.hpp"
#include "geometry/ray.hpp"

namespace raycat {

/// A CSG expression as a person would write it, from which a tree is built, and the oracle: is a
/// point in the set?
struct Expression {
  Operation operation = Operation::set_union;
  std::vector<Expression> operands;  ///< none: a leaf
  std::uint32_t leaf = 0;
};

struct Model {
  Expression expression;
  std::vector<CsgLeaf> leaves;
};

using Random = std::mt19937;

double uniform(Random& random, double low, double high);

/// Is a point inside a leaf? By the definition of each shape, not by its crossings.
bool contains(const CsgLeaf& leaf, const glm::dvec3& world);
bool contains(const Expression& e, const std::vector<CsgLeaf>& leaves, const glm::dvec3& p);

CsgTree tree_of(const Model& model);
Solid solid_of(const Model& model);

Affine placed(const glm::dvec3& at, double turn = 0.0);

/// Face ids follow one another leaf by leaf.
void add_leaf(Model& model, PlacedShape shape);

Model two(Operation operation, PlacedShape a, PlacedShape b);

/// A ball, a cylinder, a box or a half-space, turned.
PlacedShape any_shape(Random& random);

/// On an integer lattice, where flush faces are everywhere, so that ties are the rule.
PlacedShape integer_box(Random& random);

/// As `Box`, faces and all.
TriangleMesh box_mesh(const glm::dvec3& size);

/// Of up to 27 leaves.
Model any_model(unsigned seed, const std::function<PlacedShape(Random&)>& shape);

Ray any_ray(Random& random);

/// The same set with its operands in another order. Differences keep their first.
void shuffle(Expression& e, Random& random);

/// Where the line passes through the solid's boundary, and through which surface.
std::vector<std::pair<double, SurfaceId>> surfaces(const Solid& solid, const Ray& ray);

}  // namespace raycat
