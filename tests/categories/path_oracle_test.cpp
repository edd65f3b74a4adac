#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "categories/path_expression.hpp"
#include "support/random_trees.hpp"

// A second way to find out what a path expression tells of a tree: write down every word of every
// node, and try the expression on each by backtracking.
namespace raycat {
namespace {

const std::vector<std::string> object_names{"a", "it's", "b\\", "a"};
const std::vector<std::string> light_names{"a", "\"key\"", "sun"};

struct Symbol {
  char type;  // C, R, T, L or O
  std::string name;
};
using Word = std::vector<Symbol>;

struct Pattern {
  char kind = 'e';  // event, sequence (,), choice (|) or repetition (*)
  std::string text;
  std::vector<Pattern> parts;
  std::string types;      // of an event
  std::string name;       // of an event; empty: any
  bool excluded = false;  // a set: event of which `parts` are excluded
  std::size_t least = 0;
  std::size_t most = 0;
};

bool matches(const Pattern& event, const Symbol& symbol) {
  if (!event.parts.empty()) {
    const bool one = std::ranges::any_of(
        event.parts, [&](const Pattern& part) { return matches(part, symbol); });
    return event.excluded ? !one && symbol.type != 'O' && symbol.type != 'C' : one;
  }
  return event.types.find(symbol.type) != std::string::npos &&
         (event.name.empty() || event.name == symbol.name);
}

// Where in `word` a match from `start` can end.
std::set<std::size_t> ends(const Pattern& pattern, const Word& word, std::size_t start) {
  std::set<std::size_t> found;
  const auto follow = [&](const std::set<std::size_t>& starts, const Pattern& part) {
    std::set<std::size_t> next;
    for (const std::size_t at : starts) {
      next.merge(ends(part, word, at));
    }
    return next;
  };
  switch (pattern.kind) {
    case 'e':
      if (start < word.size() && matches(pattern, word[start])) {
        found.insert(start + 1);
      }
      break;
    case ',':
      found.insert(start);
      for (const Pattern& part : pattern.parts) {
        found = follow(found, part);
      }
      break;
    case '|':
      for (const Pattern& part : pattern.parts) {
        found.merge(ends(part, word, start));
      }
      break;
    default:
      std::set<std::size_t> after{start};
      for (std::size_t i = 0; i <= pattern.most; ++i) {
        if (i >= pattern.least) {
          found.insert(after.begin(), after.end());
        }
        after = follow(after, pattern.parts.front());
      }
  }
  return found;
}

bool accepted(const Pattern& pattern, const Word& word) {
  return ends(pattern, word, 0).contains(word.size());
}

std::string draw_space() { return draw_below(8) == 0 ? " " : ""; }

std::string in_quotes(const std::string& name) {
  const char mark = draw_below(2) == 0 ? '\'' : '"';
  std::string text(1, mark);
  for (const char c : name) {
    text += c == mark || c == '\\' ? std::string{'\\', c} : std::string{c};
  }
  return text + mark;
}

Pattern draw_event() {
  static const std::vector<std::pair<std::string, std::string>> kinds{
      {"R", "R"},    {"T", "T"},   {"L", "L"},     {"O", "O"},    {".", "RTL"},
      {"S", "RT"},   {"<R", "R"},  {"<T", "T"},    {"<L", "L"},   {"<O", "O"},
      {"<.", "RTL"}, {"<RS", "R"}, {"<TS", "T"},   {"<.S", "RT"}, {"<R.", "R"},
      {"<L.", "L"},  {"<O.", "O"}, {"<..", "RTL"}, {"", "RTL"}};
  Pattern event;
  std::tie(event.text, event.types) = kinds[draw_below(kinds.size())];
  const bool open = !event.text.empty() && event.text[0] == '<';
  if (event.text.empty() || (open && draw_below(2) == 0)) {
    const bool object = event.types != "L" && (event.types != "RTL" || draw_below(2) == 0);
    event.name = object ? object_names[draw_below(object_names.size())]
                        : light_names[draw_below(light_names.size())];
    event.text += draw_space() + in_quotes(event.name);
  }
  event.text += open ? draw_space() + ">" : "";
  return event;
}

Pattern draw_set() {
  Pattern set;
  set.excluded = draw_below(2) == 0;
  const bool round = set.excluded && draw_below(2) == 0;
  set.text = round ? "(" : "[";
  set.text += set.excluded ? draw_space() + "^" : "";
  for (int left = 1 + draw_below(3); left > 0; --left) {
    Pattern event = draw_event();
    while (set.excluded && event.types == "O") {
      event = draw_event();
    }
    set.text += draw_space() + event.text;
    set.parts.push_back(std::move(event));
  }
  set.text += round ? ")" : "]";
  return set;
}

Pattern draw_pattern(int depth) {
  const int kind = depth == 0 ? 0 : draw_below(10);
  if (kind < 3) {
    return draw_below(4) == 0 ? draw_set() : draw_event();
  }
  Pattern pattern;
  if (kind < 8) {
    pattern.kind = kind < 6 ? ',' : '|';
    for (int i = 1 + draw_below(3); i >= 0; --i) {
      pattern.parts.push_back(draw_pattern(depth - 1));
      pattern.text += pattern.parts.back().text + draw_space();
      pattern.text += i > 0 && pattern.kind == '|' ? "|" : "";
    }
    pattern.text = "(" + pattern.text + ")";
    return pattern;
  }
  constexpr std::size_t unlimited = 16;  // longer than any word here
  struct Operator {
    const char* text;
    std::size_t least;
    std::size_t most;
  };
  static const std::vector<Operator> operators{
      {"*", 0, unlimited}, {"*", 0, unlimited}, {"+", 1, unlimited},    {"?", 0, 1},
      {"{2}", 2, 2},       {"{0,2}", 0, 2},     {"{1,}", 1, unlimited}, {"{2,3}", 2, 3}};
  const Operator& chosen = operators[draw_below(operators.size())];
  pattern.kind = '*';
  pattern.least = chosen.least;
  pattern.most = chosen.most;
  pattern.parts.push_back(draw_pattern(depth - 1));
  const std::string& inside = pattern.parts.front().text;
  pattern.text =
      (inside.back() == ')' || pattern.parts.front().kind == 'e' ? inside : "(" + inside + ")") +
      draw_space() + chosen.text;
  return pattern;
}

Pattern draw_expression() {
  Pattern choice{.kind = '|'};
  for (int left = 1 + (draw_below(4) == 0 ? 1 : 0); left > 0; --left) {
    Pattern sequence{.kind = ','};
    sequence.parts.push_back({.text = "C", .types = "C"});
    sequence.parts.push_back(draw_pattern(3));
    choice.text += draw_space() + "C" + sequence.parts.back().text + (left > 1 ? "|" : "");
    choice.parts.push_back(std::move(sequence));
  }
  return choice;
}

SurfaceTable scene() {
  SurfaceTable table;
  for (const std::string& name : object_names) {
    table.add_object(name);
    table.add_primitive(name, 1);
  }
  return table;
}

const std::string& object_at(const RayTree& tree, HeapPosition position) {
  const auto node = std::ranges::find(tree, position, &RayNode::position);
  return object_names[static_cast<std::size_t>(node->surface)];
}

// All readings of the way to a node and of the node, with and without the O of each hit.
std::vector<Word> words(const RayTree& tree, HeapPosition position) {
  std::vector<Word> ways{{{'C', ""}}};
  if (position != root) {
    ways = words(tree, position / 2);
    for (Word& way : ways) {
      way.push_back({position % 2 == 0 ? 'T' : 'R', object_at(tree, position / 2)});
    }
  }
  std::vector<Word> all(ways);
  for (Word& way : ways) {
    way.push_back({'O', object_at(tree, position)});
    all.push_back(std::move(way));
  }
  return all;
}

RayTree told(const RayTree& tree, const Pattern& pattern) {
  RayTree kept;
  for (RayNode node : tree) {
    const std::vector<Word> ways = words(tree, node.position);
    const bool surface =
        std::ranges::any_of(ways, [&](const Word& word) { return accepted(pattern, word); });
    for (std::size_t i = 0; i < light_names.size(); ++i) {
      const bool lit = std::ranges::any_of(ways, [&](Word word) {
        word.push_back({'L', light_names[i]});
        return accepted(pattern, word);
      });
      node.lights &= lit ? ~LightMask{0} : ~(LightMask{1} << i);
    }
    node.surface = surface ? node.surface : untold;
    if (surface || node.lights != 0) {
      kept.push_back(node);
    }
  }
  return kept;
}

TEST_CASE("random expressions tell of random trees what backtracking tells",
          "[categories][paths]") {
  const SurfaceTable table = scene();
  int trees = 0;
  int partly = 0;
  int impossible = 0;
  CHECK(rc::check([&] {
    const Pattern pattern = draw_expression();
    RC_LOG() << pattern.text << std::endl;
    std::optional<PathExpression> expression;
    try {
      expression.emplace(pattern.text, table, light_names);
    } catch (const PathError& error) {
      // Nothing else can be wrong with what is drawn here.
      RC_ASSERT(std::string(error.what()).rfind("column 1: no path matches", 0) == 0);
      ++impossible;
    }
    for (int i = 0; i < 8; ++i) {
      const RayTree tree = draw_tree({.levels = 4, .surfaces = 4, .lights = 3});
      RayTree filtered(tree);
      if (expression) {
        expression->filter(filtered, table);
      } else {
        filtered.clear();
      }
      RC_ASSERT(filtered == told(tree, pattern));
      ++trees;
      partly += !filtered.empty() && filtered != tree ? 1 : 0;
    }
  }));
  // That is, the expressions are neither all too narrow nor all too wide.
  CHECK(partly > trees / 8);
  CHECK(impossible < trees / 8 / 2);
}

}  // namespace
}  // namespace raycat
