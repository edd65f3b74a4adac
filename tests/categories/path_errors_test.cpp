#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "categories/path_expression.hpp"
#include "categories/path_parser.hpp"
#include "support/random_trees.hpp"

namespace raycat {
namespace {

SurfaceTable scene() {
  SurfaceTable table;
  for (const char* name : {"ball", "wall", "floor", "lamp"}) {
    table.add_object(name);
    table.add_primitive(name, 1);
  }
  return table;
}

const std::vector<std::string> lights{"key", "fill"};

// What is wrong with `text`; empty if nothing is.
std::string error(const std::string& text) {
  const SurfaceTable table = scene();
  try {
    const PathExpression expression(text, table, lights);
  } catch (const PathError& problem) {
    const std::string what = problem.what();
    CHECK(what.rfind(fmt::format("column {}: ", problem.column), 0) == 0);
    CHECK(problem.column >= 1);
    CHECK(problem.column <= text.size() + 1);
    return what;
  }
  return {};
}

TEST_CASE("an error says where it is and what was expected", "[categories][paths]") {
  const std::string item = "an event (C, R, T, L, O, S, '.', '<', a name in quotes), '(' or '['";
  const std::string event = "an event (R, T, L, O, S, '.', '<', a name in quotes)";
  const std::vector<std::pair<std::string, std::string>> errors{
      {"", "1: the expression is empty: expected C, the camera"},
      {"  ", "1: the expression is empty: expected C, the camera"},
      {"Cx", "2: expected " + item + ", found 'x'"},
      {"C\u00e9", "2: expected " + item + ", found '\u00e9'"},
      {std::string("C\0", 2), "2: expected " + item + ", found the byte 0x00"},
      {"C>", "2: expected " + item + ", found '>'"},
      {"C]", "2: expected " + item + ", found ']'"},
      {"C|", "3: expected " + item + ", found the end"},
      {"C||CL", "3: expected " + item + ", found '|'"},
      {"C()", "3: expected " + item + ", found ')'"},
      {"C(R", "4: expected ')' for the '(' of column 2, found the end"},
      {"C[RT", "5: expected ']' for the '[' of column 2, found the end"},
      {"C[R|T]", "4: expected ']' for the '[' of column 2, found '|'"},
      {"C(^R|T)", "5: expected ')' for the '(' of column 2, found '|'"},
      {"C.*)", "4: expected the end, since no '(' is open, found ')'"},
      {"C[]", "3: expected " + event + ", found ']'"},
      {"C[^]", "4: expected " + event + ", found ']'"},
      {"C[C]", "3: expected " + event + ", found 'C': C, the camera, comes first and once"},
      {"C[RC]", "4: expected " + event + ", found 'C': C, the camera, comes first and once"},
      {"C[^O]",
       "4: expected R, T, L, S, '.' or a name: O matches only where it is written, so it cannot be "
       "excluded"},
      // What repeats.
      {"*", "1: expected an event to repeat, found '*'"},
      {"C|*", "3: expected an event to repeat, found '*'"},
      {"C(+)", "3: expected an event to repeat, found '+'"},
      {"CR**", "4: expected one repetition only, or parentheses between two, found '*'"},
      {"CR{}", "4: expected a number from 0 to 64, found '}'"},
      {"CR{65}", "4: expected a number from 0 to 64, found 65"},
      {"CR{18446744073709551617}", "4: expected a number from 0 to 64, found 18446744073709551617"},
      {"CR{2,1}", "6: expected a number from 2 to 64, found 1"},
      {"CR{2", "5: expected ',' or '}' after the number, found the end"},
      {"CR{2-3}", "5: expected ',' or '}' after the number, found '-'"},
      {"CR{2,3", "7: expected '}' after the numbers, found the end"},
      {"CR{2,x}", "6: expected a number from 0 to 64, found 'x'"},
      {"CR{0}", "5: expected a repetition that allows at least one"},
      // Between < and >.
      {"C<", "3: expected R, T, L, O or '.' after '<', found the end"},
      {"C<S>", "3: expected R, T, L, O or '.' after '<', found 'S'"},
      {"C<'ball'>", "3: expected R, T, L, O or '.' after '<', found '''"},
      {"C<R", "4: expected S, '.', a name or '>' after the type, found the end"},
      {"C<RSL>", "5: expected '>' after the scattering, found 'L'"},
      {"C<R.'ball' .>", "12: expected '>' after the name, found '.'"},
      {"C<LS>", "4: expected '.', a name or '>', since only R and T scatter, found 'S'"},
      {"C<LR>", "4: expected '.', a name or '>' after the type, found 'R'"},
      // Letters of other renderers.
      {"C<RD>L",
       "4: expected S, '.', a name or '>' after the type, found 'D': no surface scatters rays "
       "diffusely: rays reflect and refract specularly, S"},
      {"CG", "2: expected " + item +
                 ", found 'G': no surface scatters rays glossily: rays reflect and refract "
                 "specularly, S"},
      {"CV*L", "2: expected " + item + ", found 'V': there are no volumes"},
      {"C.*B", "4: expected " + item + ", found 'B': the background is no hit"},
      {"CTs",
       "3: expected " + item +
           ", found 's': a ray that goes straight through a surface is refracted, T, and its "
           "scattering is S"},
      {"EL", "1: expected " + item + ", found 'E': the camera is C"},
      // Where C may be.
      {"R", "1: expected C, the camera, before anything else"},
      {" .*", "2: expected C, the camera, before anything else"},
      {"C|(L|C)", "4: expected C, the camera, before anything else"},
      {"C?L", "3: expected C, the camera, before anything else"},
      {"CC", "2: expected no C here: C, the camera, comes first and once"},
      {"C*", "1: expected no C here: C, the camera, comes first and once"},
      {"(CR)+", "2: expected no C here: C, the camera, comes first and once"},
      {"C{2}", "1: expected no C here: C, the camera, comes first and once"},
      {"CR(L|C)", "6: expected no C here: C, the camera, comes first and once"},
      {" (C)?", "3: expected C, the camera, but all of this can be left out"},
      // Names.
      {"C'ball", "7: expected ' to end the name of column 2, found the end"},
      {"C\"ball'", "8: expected \" to end the name of column 2, found the end"},
      {"C'b\\all'", "5: expected a quote or a backslash after the backslash, found 'a'"},
      {"C'\\", "4: expected a quote or a backslash after the backslash, found the end"},
      {"C.*'bal'", "4: no object or light is named 'bal': near it are 'ball' and 'wall'"},
      {"C<R 'balk'>", "5: no object is named 'balk': near it are 'ball' and 'wall'"},
      {"C<L'kye'>", "4: no light is named 'kye': near it is 'key'"},
      {"C<R'mirror'>",
       "4: no object is named 'mirror': there are 'ball', 'wall', 'floor' and 1 more"},
      {"C<L'mirror'>", "4: no light is named 'mirror': there are 'key' and 'fill'"},
      {"C'it\\'s'",
       "2: no object or light is named 'it\\'s': there are 'ball', 'wall', 'floor' and 3 "
       "more"},
      {"C<O'key'>", "4: no object is named 'key', but a light is"},
      {"C<L'lamp'>", "4: no light is named 'lamp', but an object is"},
      {"C<.S'key'>", "5: no object is named 'key', but a light is"},
      {"C'ball''x'",
       "8: no object or light is named 'x': there are 'ball', 'wall', 'floor' and 3 more"},
      // What nothing matches.
      {"CLR",
       "1: no path matches this expression: C comes first, L last, and O only where a "
       "surface is hit"},
      {"C[^.]",
       "1: no path matches this expression: C comes first, L last, and O only where a "
       "surface is hit"},
      {"COO",
       "1: no path matches this expression: C comes first, L last, and O only where a "
       "surface is hit"},
  };
  for (const auto& [text, message] : errors) {
    CAPTURE(text);
    CHECK(error(text) == "column " + message);
  }
}

TEST_CASE("names are suggested of a scene without them", "[categories][paths]") {
  const SurfaceTable one = [] {
    SurfaceTable table;
    table.add_object("ball");
    return table;
  }();
  CHECK_THROWS_WITH(PathExpression("C<L'key'>", one, {}),
                    "column 4: no light is named 'key': there is no light");
  CHECK_THROWS_WITH(PathExpression("C<R'x'>", one, {}),
                    "column 4: no object is named 'x': there is only 'ball'");
}

TEST_CASE("messages cut long names and show no control characters", "[categories][paths]") {
  const std::string start = "column 2: no object or light is named '";
  CHECK(error("C'" + std::string(61, 'n') + "'").rfind(start + std::string(60, 'n') + "...'", 0) ==
        0);
  CHECK(error("C'" + std::string(60, 'n') + "'").rfind(start + std::string(60, 'n') + "'", 0) == 0);
  CHECK(error("C'" + std::string(59, 'n') + "\u00e9'")
            .rfind(start + std::string(59, 'n') + "...", 0) == 0);
  CHECK(error("C'\x1b[2J'").rfind(start + "\\x1b[2J'", 0) == 0);
}

TEST_CASE("more lights than a mask has are refused", "[categories][paths]") {
  CHECK_THROWS_MATCHES(PathExpression("C", scene(), std::vector<std::string>(65)),
                       std::length_error,
                       Catch::Message("path expressions know at most 64 lights, but there are 65"));
}

TEST_CASE("what is too large is refused, and what just fits is not", "[categories][paths]") {
  const auto nested = [](std::size_t depth) {
    return fmt::format("C{}R{}", std::string(depth, '('), std::string(depth, ')'));
  };
  CHECK(error(nested(64)).empty());
  CHECK(error(nested(65)) == "column 66: expected at most 64 parentheses within each other");
  CHECK(error(std::string("C").append(4000, '(')) ==
        "column 66: expected at most 64 parentheses within each other");

  CHECK(error(std::string("C").append(4095, ' ')).empty());
  CHECK(error(std::string("C").append(4096, ' ')) ==
        "column 4097: expected the end: an expression has at most 4096 characters, found 4097");

  CHECK(error(std::string("C").append(511, 'R')).empty());
  const std::string events =
      "column 1: the expression has more than 512 events, counting how often each is repeated: "
      "expected a simpler one";
  CHECK(error(std::string("C").append(512, 'R')) == events);
  CHECK(error("C(R{64}){64}") == events);
  CHECK(error("C((((R{64}){64}){64}){64})?") == events);

  CHECK(error("CS*R.{10}").empty());
  CHECK(error("CS*RS{12}") ==
        "column 1: the expression takes an automaton of more than 4096 states: expected a simpler "
        "one");
}

TEST_CASE("many names make fewer states", "[categories][paths]") {
  SurfaceTable table;
  std::string names;
  for (int i = 0; i < 31; ++i) {
    names += fmt::format("'{}'", i);
    table.add_object(std::to_string(i));
  }
  CHECK_NOTHROW(PathExpression("C.*[" + names + "]L?", table, {}));
  CHECK_THROWS_WITH(PathExpression("CS*RS{9}[" + names + "]", table, {}),
                    "column 1: the expression takes an automaton of more than 512 states with its "
                    "31 names: expected a simpler one");
}

TEST_CASE("whatever the text is, it is read or refused with a column of it",
          "[categories][paths]") {
  const std::vector<std::string> tokens{"C", "R", "T", "L",  "O",  "S",   ".",      "<",     ">",
                                        "(", ")", "[", "]",  "^",  "|",   "*",      "+",     "?",
                                        "{", "}", ",", "'",  "\"", "\\",  "'ball'", "'key'", "1",
                                        "2", "D", " ", "(^", "[^", "<R.", "\n",     "\x80",  "C.*"};
  const SurfaceTable table = scene();
  CHECK(rc::check([&] {
    std::string text = "C";
    for (std::size_t left = draw_below(std::size_t{20}); left > 0; --left) {
      text += tokens[draw_below(tokens.size())];
    }
    try {
      const PathExpression expression(text, table, lights);
    } catch (const PathError& problem) {
      RC_ASSERT(problem.column >= 1u);
      RC_ASSERT(problem.column <= text.size() + 1);
    }
  }));
}

}  // namespace
}  // namespace raycat
