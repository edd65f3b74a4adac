#include "categories/path_expression.hpp"

#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "categories/detail.hpp"
#include "support/paper_trees.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

using paper::A;
using paper::B;
using paper::C;
using paper::L;

// A table of objects of one face each.
SurfaceTable objects(const std::vector<std::string>& names) {
  SurfaceTable table;
  for (const std::string& name : names) {
    table.add_object(name);
    table.add_primitive(name, 1);
  }
  return table;
}

// What is left of a tree of objects A, B and C under lights L and M.
RayTree told(const RayTree& tree, std::string_view expression) {
  const SurfaceTable table = objects({"A", "B", "C"});
  const std::vector<std::string> lights{"L", "M"};
  RayTree copy(tree);
  PathExpression(expression, table, lights).filter(copy, table);
  return copy;
}

TEST_CASE("expressions tell of Fig. 2 the parts that they match", "[categories][paths]") {
  struct Row {
    const char* expression;
    RayTree a;
    RayTree b;
  };
  const RayNode a_root{.surface = A};
  const RayNode b_root{.lights = L, .surface = A};
  const RayNode inside{.position = 2, .lights = L, .surface = A};
  const RayNode deeper{.position = 5, .lights = L, .surface = A};
  const RayNode beside{.position = 3, .lights = L, .surface = B};
  const auto dark = [](RayNode node) {
    node.lights = 0;
    return node;
  };
  const auto lit_only = [](RayNode node) {
    node.surface = untold;
    return node;
  };
  const auto row = GENERATE_COPY(
      Row{"C.*", paper::fig2_a, paper::fig2_b}, Row{"C[RT]*[LO]", paper::fig2_a, paper::fig2_b},
      Row{"C", {a_root}, {dark(b_root)}}, Row{"C|CL", {a_root}, {b_root}},
      Row{"CL?", {a_root}, {b_root}}, Row{"CL", {}, {lit_only(b_root)}},
      Row{"C.*L", {lit_only(deeper), lit_only(inside)}, {lit_only(beside), lit_only(b_root)}},
      Row{"C[^L]*", {dark(deeper), dark(inside), a_root}, {dark(beside), dark(b_root)}},
      Row{"CS*", {dark(deeper), dark(inside), a_root}, {dark(beside), dark(b_root)}},
      Row{"CS+", {dark(deeper), dark(inside)}, {dark(beside)}}, Row{"C<RS>.*", {}, {beside}},
      Row{"C<R.>.*", {}, {beside}}, Row{"C<T.>.*", {deeper, inside}, {}},
      Row{"C<TS>", {dark(inside)}, {}}, Row{"CTL", {lit_only(inside)}, {}},
      Row{"CTRL?", {deeper}, {}}, Row{"C(TR)?L?", {deeper, a_root}, {b_root}},
      Row{"C.", {dark(inside)}, {dark(beside), lit_only(b_root)}},
      Row{"C..", {dark(deeper), lit_only(inside)}, {lit_only(beside)}},
      Row{"C.{2}", {dark(deeper), lit_only(inside)}, {lit_only(beside)}},
      Row{"C.{1,2}", {dark(deeper), inside}, {beside, lit_only(b_root)}},
      Row{"C.{2,}", {deeper, lit_only(inside)}, {lit_only(beside)}},
      Row{"C(^T).*", {}, {beside, lit_only(b_root)}}, Row{"C[^TL].*", {}, {beside}},
      Row{"C(T|R)", {dark(inside)}, {dark(beside)}});
  CAPTURE(row.expression);
  CHECK(told(paper::fig2_a, row.expression) == row.a);
  CHECK(told(paper::fig2_b, row.expression) == row.b);
  CHECK(told(paper::fig2_c, row.expression).empty());
}

// Mirror A shows B, which M lights; behind glass C, entered and left, are A and its light L.
const RayTree show{{.position = 4, .lights = 1, .surface = A},
                   {.position = 2, .lights = 0, .surface = C},
                   {.position = 7, .lights = 3, .surface = C},
                   {.position = 3, .lights = 2, .surface = B},
                   {.position = 1, .lights = 3, .surface = A}};

// The positions that are told, and those of which the lights alone are, negated.
std::vector<int> positions(std::string_view expression) {
  std::vector<int> list;
  for (const RayNode& node : told(show, expression)) {
    const int position = static_cast<int>(node.position);
    list.push_back(node.surface == untold ? -position : position);
  }
  return list;
}

TEST_CASE("a name on R or T is of the object that the ray leaves", "[categories][paths]") {
  using Positions = std::vector<int>;
  CHECK(positions("C<R'A'>") == Positions{3});
  CHECK(positions("C<R.'B'>").empty());
  CHECK(positions("CR<RS'B'>") == Positions{7});
  CHECK(positions("C<T'A'><T'C'>") == Positions{4});
  CHECK(positions("C.*'A'.*") == Positions{4, 2, 7, 3});
  CHECK(positions("C.*<.'B'>") == Positions{7});
  CHECK(positions("C.*<.S\"C\">") == Positions{4});
  CHECK(positions("C['A''C']*") == Positions{4, 2, 3, 1});
  CHECK(positions("C[^'A']*") == Positions{1});
}

TEST_CASE("a name on L is the light's", "[categories][paths]") {
  const RayTree m = told(show, "C.*<L'M'>");
  CHECK(m == RayTree{{.position = 7, .lights = 2, .surface = untold},
                     {.position = 3, .lights = 2, .surface = untold},
                     {.position = 1, .lights = 2, .surface = untold}});
  CHECK(told(show, "C.*'M'") == m);
  CHECK(told(show, "CR.*<L.'L'>") == RayTree{{.position = 7, .lights = 1, .surface = untold}});
  CHECK(told(show, "C[^'M']*") == told(show, "C([RT]*|[RT]*<L'L'>)"));
}

TEST_CASE("a name on O is of the object that is hit", "[categories][paths]") {
  using Positions = std::vector<int>;
  CHECK(positions("C.*<O'C'>") == Positions{2, 7});
  CHECK(positions("C.*<O.'C'>L") == Positions{-7});
  CHECK(positions("C.*<O'A'>L?") == Positions{4, 1});
  CHECK(positions("C<O'A'>") == Positions{1});
  CHECK(positions("C<O'B'>").empty());
  CHECK(positions("CO<R>O") == Positions{3});
}

TEST_CASE("O before R or T names what these leave", "[categories][paths]") {
  for (const char* name : {"A", "B", "C"}) {
    CHECK(told(show, fmt::format("C.*<O'{}'>R.*", name)) ==
          told(show, fmt::format("C.*<R'{}'>.*", name)));
  }
}

TEST_CASE("O matches once at a hit, and only where it is written", "[categories][paths]") {
  CHECK(told(show, "CO") == told(show, "C"));
  CHECK(told(show, "CO*L") == told(show, "CL"));
  CHECK(told(show, "C(OR)*O?L?") == told(show, "CR*L?"));
  CHECK(positions("CR.") == std::vector<int>{7, -3});
  CHECK(positions("CR[^R]") == std::vector<int>{-3});
}

TEST_CASE("all objects of a name answer to it", "[categories][paths]") {
  const SurfaceTable table = objects({"ball", "floor", "ball"});
  const std::vector<std::string> lights{"sun", "lamp", "sun"};
  RayTree tree{{.position = 2, .lights = 7, .surface = SurfaceId{2}},
               {.position = 3, .lights = 7, .surface = SurfaceId{1}},
               {.position = 1, .lights = 7, .surface = SurfaceId{0}}};
  PathExpression("C.*<O'ball'><L'sun'>", table, lights).filter(tree, table);
  CHECK(tree == RayTree{{.position = 2, .lights = 5, .surface = untold},
                        {.position = 1, .lights = 5, .surface = untold}});
}

TEST_CASE("a name that an object and a light share stands for both", "[categories][paths]") {
  const SurfaceTable table = objects({"lamp", "floor"});
  const std::vector<std::string> lights{"sun", "lamp"};
  RayTree tree{{.position = 3, .lights = 3, .surface = SurfaceId{1}},
               {.position = 1, .lights = 3, .surface = SurfaceId{0}}};
  PathExpression("C'lamp'", table, lights).filter(tree, table);
  CHECK(tree == RayTree{{.position = 3, .lights = 0, .surface = SurfaceId{1}},
                        {.position = 1, .lights = 2, .surface = untold}});
}

TEST_CASE("names may hold quotes, backslashes and spaces", "[categories][paths]") {
  const auto name =
      GENERATE(std::pair(R"(it's)", R"('it\'s')"), std::pair(R"(it's)", R"("it's")"),
               std::pair(R"(4" pipe)", R"('4" pipe')"), std::pair(R"(4" pipe)", R"("4\" pipe")"),
               std::pair(R"(a\b)", R"('a\\b')"), std::pair(" L | <C> ", "' L | <C> '"),
               std::pair("", "''"), std::pair("K\u00f6rper", "'K\u00f6rper'"));
  const SurfaceTable table = objects({name.first, "other"});
  RayTree tree{{.position = 3, .surface = SurfaceId{1}}, {.position = 1, .surface = SurfaceId{0}}};
  PathExpression(fmt::format("C.*<O{}>", name.second), table, {}).filter(tree, table);
  CHECK(tree == RayTree{{.position = 1, .surface = SurfaceId{0}}});
}

TEST_CASE("white space between tokens does not count", "[categories][paths]") {
  CHECK(told(show, " C\t( < R . 'A' > | T )\n{ 1 , 2 } L ? ") == told(show, "C(<R.'A'>|T){1,2}L?"));
}

TEST_CASE("levels and lights are presets", "[categories][paths]") {
  const SurfaceTable table = objects({"A", "B", "C"});
  CHECK(rc::check([&] {
    const RayTree tree = draw_tree({.levels = 7});
    for (int levels = 1; levels <= 8; ++levels) {
      for (const bool lights : {false, true}) {
        RayTree reduced(tree);
        reduce(reduced, {.levels = levels, .lights = lights}, table);
        RayTree filtered(tree);
        const std::string preset =
            fmt::format("C[^L]{{0,{}}}{}", std::max(levels - 1, 1), lights ? "L?" : "");
        const PathExpression expression(levels == 1 ? lights ? "CL?" : "C" : preset, table, {});
        expression.filter(filtered, table);
        RC_ASSERT(filtered == reduced);
      }
    }
    RayTree all(tree);
    PathExpression("C.*", table, {}).filter(all, table);
    RC_ASSERT(all == tree);
  }));
}

TEST_CASE("lights past those with a name are L but have none", "[categories][paths]") {
  const RayTree tree{{.lights = ~LightMask{0}, .surface = A}};
  CHECK(told(tree, "CL").front().lights == ~LightMask{0});
  CHECK(told(tree, "C<L'M'>").front().lights == 2);
  CHECK(told(tree, "C[^'M']").front().lights == ~LightMask{2});
}

TEST_CASE("paths reach the deepest level there is", "[categories][paths]") {
  RayTree tree;
  for (int i = most_levels; i > 0; --i) {
    tree.push_back({.position = ~HeapPosition{0} >> (most_levels - i), .lights = 1, .surface = A});
  }
  CHECK(told(tree, "CR{63}L?") == RayTree{tree.front()});
  CHECK(told(tree, "CR{64}").empty());
  CHECK(told(tree, "CR*L?") == tree);
}

TEST_CASE("a node without its parent is dropped, since its word is not known",
          "[categories][paths]") {
  const RayTree torn{{.position = 4, .surface = A}, {.position = 3, .surface = B}, {.surface = A}};
  CHECK(told(torn, "C.*") == RayTree{torn[1], torn[2]});
  CHECK(told({{.position = 2, .surface = A}}, "C.*").empty());
}

TEST_CASE("filtering again changes nothing more", "[categories][paths]") {
  CHECK(rc::check([] {
    const RayTree once = told(draw_tree({}), "C(R|T<O'B'>)*(L|O)?");
    RC_ASSERT(told(once, "C.*") == once);
  }));
}

TEST_CASE("filtering keeps the tree's memory", "[categories][paths]") {
  const SurfaceTable table = objects({"A", "B", "C"});
  const PathExpression expression("CR.*", table, {});
  RayTree tree(show);
  const RayNode* const data = tree.data();
  const std::size_t capacity = tree.capacity();
  expression.filter(tree, table);
  CHECK(tree.size() == 2);
  CHECK(tree.data() == data);
  CHECK(tree.capacity() == capacity);
}

TEST_CASE("a detail of paths gives one surface to all that are untold", "[categories][paths]") {
  const SurfaceTable table = objects({"A", "B", "C"});
  const Detail detail{
      .paths = std::make_shared<const PathExpression>("CL", table, std::vector<std::string>{})};
  RayTree tree(show);
  reduce(tree, detail, table);
  CHECK(tree == RayTree{{.lights = 3, .surface = SurfaceId{3}}});
}

}  // namespace
}  // namespace raycat
