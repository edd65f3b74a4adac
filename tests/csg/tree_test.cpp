#include "csg/tree.hpp"

#include <array>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

CsgLeaf ball() { return {.shape = PlacedShape(Sphere{.radius = 1.0})}; }

TEST_CASE("an operation names its operands' parent and what it subtracts", "[csg][tree]") {
  CsgTree tree;
  const std::array operands{tree.add(ball()), tree.add(ball()), tree.add(ball())};
  tree.add(Operation::difference, operands);
  CHECK_NOTHROW(tree.require_complete());
  CHECK(tree.leaves().size() == 3);
  CHECK(tree.nodes()[0].parent == 3);
  CHECK_FALSE(tree.nodes()[0].subtracted);
  CHECK(tree.nodes()[1].subtracted);
  CHECK(tree.nodes()[2].subtracted);
  CHECK(tree.nodes()[3].parent == CsgTree::no_parent);
}

TEST_CASE("a tree that is not one tree is refused", "[csg][tree]") {
  CsgTree tree;
  CHECK_THROWS_WITH(tree.require_complete(), "a CSG tree needs at least one operand");
  CHECK_THROWS_WITH(tree.add(Operation::set_union, {}),
                    "a set operation needs at least one operand");
  const std::array first{tree.add(ball())};
  tree.add(Operation::set_union, first);
  CHECK_THROWS_WITH(tree.add(Operation::set_union, first),
                    "an operand belongs to two set operations");
  tree.add(ball());
  CHECK_THROWS_WITH(tree.require_complete(), "an operand belongs to no set operation");
}

}  // namespace
}  // namespace raycat
