#include "io/openscad/parser.hpp"

#include <utility>

#include <fmt/format.h>

#include "io/files/load_error.hpp"
#include "io/openscad/lexer.hpp"

namespace raycat::openscad {

namespace {

// The deepest parameter, a polyhedron's points, is two deep. The bound keeps values, which
// unlike nodes are nested objects, from using up the stack.
constexpr int most_nested_vectors = 16;

// What a string's escapes stand for: \" \\ \n \r \t; of others the backslash stays.
std::string unescaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    constexpr std::string_view escapes = "\"\\nrt";
    constexpr std::string_view meanings = "\"\\\n\r\t";
    const std::size_t which =
        text[i] == '\\' && i + 1 < text.size() ? escapes.find(text[i + 1]) : std::string_view::npos;
    out += which == std::string_view::npos ? text[i] : meanings[which];
    i += which == std::string_view::npos ? 0U : 1U;
  }
  return out;
}

class Parser {
 public:
  Parser(const std::filesystem::path& file, std::string_view text)
      : file_(file), lexer_(file, text), token_(lexer_.next()) {}

  File parse();

 private:
  bool at(std::string_view symbol) const {
    return token_.kind == Token::Kind::symbol && token_.text == symbol;
  }
  Token take() { return std::exchange(token_, lexer_.next()); }
  bool take_if(std::string_view symbol);
  [[noreturn]] void fail(std::string_view expected) const;

  void assignment();
  void node(std::uint32_t parent);
  Argument argument();
  Value value(int depth);
  Value word_value(bool negative);

  const std::filesystem::path& file_;
  Lexer lexer_;
  Token token_;
  File out_;
};

bool Parser::take_if(std::string_view symbol) {
  const bool found = at(symbol);
  if (found) {
    take();
  }
  return found;
}

void Parser::fail(std::string_view expected) const {
  throw LoadError(file_, line_place(token_.line),
                  fmt::format("expected {}, but found {}", expected, quoted(token_)));
}

File Parser::parse() {
  out_.nodes.push_back({.name = "group", .line = 1});
  std::uint32_t open = 0;  // the node whose children are being read
  while (token_.kind != Token::Kind::end) {
    if (at("}") && open != 0) {
      take();
      out_.nodes[open].end = static_cast<std::uint32_t>(out_.nodes.size());
      open = out_.nodes[open].parent;
    } else if (token_.kind == Token::Kind::word && token_.text.starts_with('$') && open == 0) {
      assignment();
    } else if (!take_if(";")) {
      node(open);
      const auto added = static_cast<std::uint32_t>(out_.nodes.size() - 1);
      if (take_if("{")) {
        open = added;
      } else if (take_if(";")) {
        out_.nodes[added].end = added + 1;
      } else {
        fail("';' or '{'");
      }
    }
  }
  if (open != 0) {
    fail(fmt::format("'}}' of {} in line {}", out_.nodes[open].name, out_.nodes[open].line));
  }
  out_.nodes[0].end = static_cast<std::uint32_t>(out_.nodes.size());
  return std::move(out_);
}

void Parser::assignment() {
  const Token name = take();
  if (!take_if("=")) {
    fail(fmt::format("'=' after {}", name.text));
  }
  out_.assignments.push_back({.name = name.text, .value = value(0), .line = name.line});
  if (!take_if(";")) {
    fail("';'");
  }
}

void Parser::node(std::uint32_t parent) {
  Node node{.parent = parent};
  for (bool modifiers = true; modifiers;) {
    if (take_if("%")) {
      node.background = true;
    } else if (take_if("!")) {
      node.root = true;
    } else if (take_if("*")) {
      node.disabled = true;
    } else {
      modifiers = take_if("#");
    }
  }
  if (token_.kind != Token::Kind::word || token_.text.starts_with('$')) {
    fail(parent == 0 ? "the name of a node" : "the name of a node or '}'");
  }
  const Token name = take();
  node.name = name.text;
  node.line = name.line;
  if (!take_if("(")) {
    fail(fmt::format("'(' after {}", name.text));
  }
  while (!take_if(")")) {
    node.arguments.push_back(argument());
    if (!at(")") && !take_if(",")) {
      fail("',' or ')'");
    }
  }
  out_.nodes.push_back(std::move(node));
}

Argument Parser::argument() {
  if (token_.kind != Token::Kind::word) {
    return {.name = {}, .value = value(0)};
  }
  // A word is a parameter's name only if = follows; else it is a value.
  const Token word = token_;
  Lexer ahead = lexer_;
  const Token next = ahead.next();
  if (next.kind != Token::Kind::symbol || next.text != "=") {
    return {.name = {}, .value = value(0)};
  }
  take();
  take();
  return {.name = word.text, .value = value(0)};
}

Value Parser::value(int depth) {
  if (token_.kind == Token::Kind::number) {
    return {.is = take().number};
  }
  if (token_.kind == Token::Kind::string) {
    return {.is = unescaped(take().text)};
  }
  if (take_if("-")) {
    return word_value(true);
  }
  if (token_.kind == Token::Kind::word) {
    return word_value(false);
  }
  if (!at("[")) {
    fail("a value");
  }
  if (depth == most_nested_vectors) {
    throw LoadError(file_, line_place(token_.line),
                    fmt::format("vectors are at most {} deep", most_nested_vectors));
  }
  take();
  Vector elements;
  while (!take_if("]")) {
    elements.push_back(value(depth + 1));
    if (!at("]") && !take_if(",")) {
      fail("',' or ']'");
    }
  }
  return {.is = std::move(elements)};
}

Value Parser::word_value(bool negative) {
  const bool word = token_.kind == Token::Kind::word;
  if (word && (token_.text == "inf" || token_.text == "nan")) {
    take();
    return {.is = Unknown{}};
  }
  if (word && !negative && token_.text == "undef") {
    take();
    return {.is = Unknown{}};
  }
  if (word && !negative && (token_.text == "true" || token_.text == "false")) {
    return {.is = take().text == "true"};
  }
  fail("a value");
}

}  // namespace

File parse(const std::filesystem::path& file, std::string_view text) {
  return Parser(file, text).parse();
}

}  // namespace raycat::openscad
