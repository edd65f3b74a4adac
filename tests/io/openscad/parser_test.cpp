#include "io/openscad/parser.hpp"

#include <string>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

std::string error_of(const std::string& text) { return load_error("a.csg", text); }

TEST_CASE("nodes are listed before their children and know where these end", "[io][openscad]") {
  const std::string text =
      "// by hand\n$fn = 8;\ngroup() {\n\tcube(size = [1, -2.5e-3, inf], center = true);\n"
      "\t%sphere(r = 1); /* two\nlines */ #union() { }\n}\n";
  const openscad::File file = openscad::parse("a.csg", text);
  REQUIRE(file.nodes.size() == 5);
  CHECK(file.nodes[1].name == "group");
  CHECK(file.nodes[1].line == 3);
  CHECK(file.nodes[1].end == 5);
  CHECK(file.nodes[2].parent == 1);
  CHECK(file.nodes[2].end == 3);
  CHECK(file.nodes[3].background);
  CHECK(file.nodes[4].line == 6);
  REQUIRE(file.nodes[2].arguments.size() == 2);
  CHECK(file.nodes[2].arguments[0].name == "size");
  const openscad::Vector& size = *file.nodes[2].arguments[0].value.vector();
  CHECK(*size[1].number() == -0.0025);
  CHECK(std::holds_alternative<openscad::Unknown>(size[2].is));
  REQUIRE(file.assignments.size() == 1);
  CHECK(file.assignments[0].name == "$fn");
}

TEST_CASE("malformed .csg files are refused with the line and what was expected there",
          "[io][openscad]") {
  CHECK(error_of("cube(\n") == "a.csg: line 2: expected a value, but found the end of the file");
  CHECK(error_of("cube()") == "a.csg: line 1: expected ';' or '{', but found the end of the file");
  CHECK(error_of("cube;") == "a.csg: line 1: expected '(' after cube, but found ';'");
  CHECK(error_of("\ngroup() {\ncube();\n") ==
        "a.csg: line 4: expected '}' of group in line 2, but found the end of the file");
  CHECK(error_of("}") == "a.csg: line 1: expected the name of a node, but found '}'");
  CHECK(error_of("group() { 5 }") ==
        "a.csg: line 1: expected the name of a node or '}', but found '5'");
  CHECK(error_of("cube(size = [1, 2;") == "a.csg: line 1: expected ',' or ']', but found ';'");
  CHECK(error_of("cube(1 2);") == "a.csg: line 1: expected ',' or ')', but found '2'");
  CHECK(error_of("cube(size = x);") == "a.csg: line 1: expected a value, but found 'x'");
  CHECK(error_of("$fn 5;") == "a.csg: line 1: expected '=' after $fn, but found '5'");
  CHECK(error_of("cube(1e999);") == "a.csg: line 1: the number 1e999 is out of range");
  CHECK(error_of("cube(12ab);") == "a.csg: line 1: malformed number");
  CHECK(error_of("text(\"abc\n") == "a.csg: line 1: string without closing quote");
  CHECK(error_of("\n/* abc") == "a.csg: line 2: comment without */");
  CHECK(error_of("cube(@);") == "a.csg: line 1: unexpected character '@'");
  CHECK(error_of(std::string("cube(\0);", 8)) == "a.csg: line 1: unexpected byte 0x00");
  CHECK(error_of("cube(" + std::string(100'000, '[') + ");") ==
        "a.csg: line 1: vectors are at most 16 deep");
}

TEST_CASE("a million groups within each other load", "[io][openscad]") {
  std::string text;
  constexpr int depth = 1'000'000;
  for (int i = 0; i < depth; ++i) {
    text += "group(){";
  }
  text += "cube();" + std::string(depth, '}');
  CHECK(load_text("deep.csg", text).scene.surfaces.primitives() == 1);
}

TEST_CASE("damaged .csg files load or are refused with one line", "[io][openscad]") {
  const std::string whole =
      "$vpd = 140;\ngroup() {\n multmatrix([[1, 0, 0, 4], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, "
      "1]]) "
      "{\n  difference() { cube(size = [1, 2, 3], center = true);\n #cylinder($fn = 0, $fa = 12, "
      "$fs "
      "= 2, h = 4, r1 = 1, r2 = 0); } }\n color([1, 0, -1, 1]) { sphere($fn = 5, r = 2); }\n "
      "polyhedron(points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], faces = [[0, 1, 2], [0, "
      "3, "
      "1], [1, 3, 2], [0, 2, 3]]);\n}\n";
  CHECK(load_error("a.csg", whole).empty());
  CHECK(rc::check("damage", [&whole] {
    std::string damaged = whole;
    const int bytes = *rc::gen::inRange(0, 4);
    for (int i = 0; i < bytes; ++i) {
      damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] =
          *rc::gen::oneOf(rc::gen::elementOf(whole), rc::gen::arbitrary<char>());
    }
    damaged.resize(*rc::gen::inRange<std::size_t>(1, damaged.size() + 1));
    const std::string message = load_error("damaged.csg", damaged);
    RC_ASSERT(message.find('\n') == std::string::npos);
  }));
}

}  // namespace
}  // namespace raycat
