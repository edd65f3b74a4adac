#include "io/povray/tree.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace raycat {
namespace {

using NodeId = CsgTree::NodeId;

NodeId leaf(CsgTree& tree) { return tree.add(CsgLeaf{.shape = PlacedShape(Sphere{})}); }

std::string text_of(const CsgTree& tree, bool merge = false) {
  std::string text = pov_tree(
      tree, merge, [](const CsgLeaf&, std::size_t i) { return "leaf { " + std::to_string(i); });
  text += "}";
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// What POV-Ray reads in the text: is a point in it that is in the leaves of `inside`?
bool read(std::istream& in, unsigned inside) {
  std::string word;
  std::string brace;
  in >> word >> brace;
  REQUIRE(brace == "{");
  if (word == "leaf") {
    unsigned index = 0;
    in >> index >> brace;
    REQUIRE(brace == "}");
    return ((inside >> index) & 1U) != 0;
  }
  bool result = read(in, inside);
  while (in >> std::ws && in.peek() != '}') {
    const bool next = read(in, inside);
    result = word == "union" || word == "merge" ? result || next
             : word == "intersection"           ? result && next
                                                : result && !next;
  }
  in >> brace;
  return result;
}

// The same by the tree.
bool contains(const CsgTree& tree, unsigned inside) {
  const auto nodes = tree.nodes();
  std::vector<std::vector<bool>> operands(nodes.size());
  bool value = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].leaf != CsgTree::no_leaf) {
      value = ((inside >> nodes[i].leaf) & 1U) != 0;
    } else {
      value = operands[i].front();
      for (std::size_t k = 1; k < operands[i].size(); ++k) {
        const bool next = operands[i][k];
        value = nodes[i].operation == Operation::set_union      ? value || next
                : nodes[i].operation == Operation::intersection ? value && next
                                                                : value && !next;
      }
    }
    if (nodes[i].parent != CsgTree::no_parent) {
      operands[nodes[i].parent].push_back(value);
    }
  }
  return value;
}

constexpr std::array operations{Operation::set_union, Operation::intersection,
                                Operation::difference};

TEST_CASE("a set operation goes on where the one around it begins", "[io][pov]") {
  CsgTree tree;
  const auto pair = [&](Operation operation, NodeId a, NodeId b) {
    return tree.add(operation, std::array{a, b});
  };
  SECTION("a - b - c is one difference") {
    const NodeId ab = pair(Operation::difference, leaf(tree), leaf(tree));
    pair(Operation::difference, ab, leaf(tree));
    CHECK(text_of(tree) == "difference { leaf { 0 } leaf { 1 } leaf { 2 } }");
  }
  SECTION("a - (b - c) is two") {
    const NodeId a = leaf(tree);
    pair(Operation::difference, a, pair(Operation::difference, leaf(tree), leaf(tree)));
    CHECK(text_of(tree) == "difference { leaf { 0 } difference { leaf { 1 } leaf { 2 } } }");
  }
  SECTION("operations on one operand are none") {
    const NodeId one = tree.add(Operation::difference, std::array{leaf(tree)});
    tree.add(Operation::intersection, std::array{one});
    CHECK(text_of(tree) == "leaf { 0 }");
  }
  SECTION("transparent unions are merged") {
    pair(Operation::set_union, leaf(tree), leaf(tree));
    CHECK(text_of(tree, true) == "merge { leaf { 0 } leaf { 1 } }");
  }
}

TEST_CASE("the text of a random tree is the tree's set", "[io][pov]") {
  const auto seed = static_cast<unsigned>(GENERATE(range(0, 200)));
  std::mt19937 random(seed);
  CsgTree tree;
  std::vector<NodeId> roots;
  for (int i = 0; i < 8; ++i) {
    roots.push_back(leaf(tree));
  }
  while (roots.size() > 1 || random() % 3 == 0) {
    std::vector<NodeId> operands;
    for (std::size_t n = 1 + random() % 3; n > 0 && !roots.empty(); --n) {
      const auto at = roots.begin() + static_cast<std::ptrdiff_t>(random() % roots.size());
      operands.push_back(*at);
      roots.erase(at);
    }
    roots.push_back(tree.add(operations[random() % operations.size()], operands));
  }
  const std::string text = text_of(tree, random() % 2 == 0);
  INFO(text);
  for (unsigned inside = 0; inside < 256; ++inside) {
    std::istringstream in(text);
    REQUIRE(read(in, inside) == contains(tree, inside));
  }
}

TEST_CASE("the depth of a tree costs no stack", "[io][pov]") {
  constexpr int depth = 200000;
  const bool alternating = GENERATE(false, true);
  CsgTree tree;
  NodeId root = leaf(tree);
  for (int i = 0; i < depth; ++i) {
    const Operation operation =
        alternating && i % 2 == 0 ? Operation::set_union : Operation::difference;
    root = tree.add(operation, std::array{root, leaf(tree)});
  }
  const std::string text = text_of(tree);
  CHECK(std::ranges::count(text, '{') == std::ranges::count(text, '}'));
  CHECK(std::ranges::count(text, '{') == (alternating ? 2 * depth + 1 : depth + 2));
}

}  // namespace
}  // namespace raycat
