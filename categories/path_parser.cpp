#include "categories/path_parser.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "categories/camera_place.hpp"
#include "categories/path_error.hpp"
#include "categories/path_text.hpp"

namespace raycat::paths {
namespace {

constexpr std::string_view repetitions = "*+?{";

// Reads by recursive descent: choice, sequence, repetition, item. Only parentheses recurse.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  PathSyntax parse() {
    if (text_.at_end()) {
      throw PathError(1, "the expression is empty: expected C, the camera");
    }
    syntax_.expression = choice();
    if (!text_.at_end()) {
      text_.fail("the end, since no '(' is open");
    }
    return std::move(syntax_);
  }

 private:
  PathNode choice() {
    PathNode node{.column = text_.column()};
    std::vector<PathNode> parts;
    do {
      parts.push_back(sequence());
    } while (text_.take('|'));
    if (parts.size() == 1) {
      return std::move(parts.front());
    }
    node.optional = std::ranges::any_of(parts, &PathNode::optional);
    node.form = Choice{std::move(parts)};
    return node;
  }

  PathNode sequence() {
    PathNode node{.column = text_.column()};
    std::vector<PathNode> parts;
    do {
      parts.push_back(repetition());
    } while (!text_.at_end() && !text_.at_any("|)"));
    if (parts.size() == 1) {
      return std::move(parts.front());
    }
    node.optional = std::ranges::all_of(parts, &PathNode::optional);
    node.form = Sequence{std::move(parts)};
    return node;
  }

  PathNode repetition() {
    PathNode part = item();
    Repetition repetition;
    if (text_.take('*')) {
      repetition.least = 0;
    } else if (text_.take('+')) {
      repetition.least = 1;
    } else if (text_.take('?')) {
      repetition.most = 1;
    } else if (text_.take('{')) {
      repetition = counts();
    } else {
      return part;
    }
    if (text_.at_any(repetitions)) {
      text_.fail("one repetition only, or parentheses between two");
    }
    PathNode node{.column = part.column, .optional = part.optional || repetition.least == 0};
    repetition.part.push_back(std::move(part));
    node.form = std::move(repetition);
    return node;
  }

  // What is left of {n}, {n,} or {n,m}.
  Repetition counts() {
    Repetition repetition;
    repetition.least = text_.number(most_repeats);
    repetition.most = repetition.least;
    if (text_.take(',')) {
      repetition.most.reset();
      if (!text_.at_any("}")) {
        const std::size_t column = text_.column();
        repetition.most = text_.number(most_repeats);
        if (*repetition.most < repetition.least) {
          throw PathError(column, fmt::format("expected a number from {} to {}, found {}",
                                              repetition.least, most_repeats, *repetition.most));
        }
      }
    }
    const std::size_t column = text_.column();
    if (!text_.take('}')) {
      text_.fail(repetition.most == repetition.least ? "',' or '}' after the number"
                                                     : "'}' after the numbers");
    }
    if (repetition.most == 0) {
      throw PathError(column, "expected a repetition that allows at least one");
    }
    return repetition;
  }

  PathNode item() {
    PathNode node{.column = text_.column()};
    if (text_.take('C')) {
      node.form = CameraEvent{};
    } else if (text_.take('(')) {
      return text_.take('^') ? set(node.column, '(', ')', true) : group(node.column);
    } else if (text_.take('[')) {
      const bool excluded = text_.take('^');
      return set(node.column, '[', ']', excluded);
    } else if (const std::optional<EventTerm> term = event()) {
      node.form = EventSet{.terms = {*term}};
    } else if (text_.at_any(repetitions)) {
      text_.fail("an event to repeat");
    } else {
      text_.fail("an event (C, R, T, L, O, S, '.', '<', a name in quotes), '(' or '['");
    }
    return node;
  }

  PathNode group(std::size_t opened) {
    if (++nesting_ > most_nesting) {
      throw PathError(
          opened, fmt::format("expected at most {} parentheses within each other", most_nesting));
    }
    PathNode inside = choice();
    close('(', ')', opened);
    --nesting_;
    return inside;
  }

  PathNode set(std::size_t opened, char open, char close_with, bool excluded) {
    EventSet set{.excluded = excluded};
    do {
      const std::size_t column = text_.column();
      const std::optional<EventTerm> term = event();
      if (!term) {
        if (set.terms.empty() || text_.at_any("C")) {
          text_.fail("an event (R, T, L, O, S, '.', '<', a name in quotes)");
        }
        break;
      }
      if (excluded && (term->types & hit_event) != 0) {
        throw PathError(column,
                        "expected R, T, L, S, '.' or a name: O matches only where it is "
                        "written, so it cannot be excluded");
      }
      set.terms.push_back(*term);
    } while (!text_.at_end() && !text_.at_any(std::string_view(&close_with, 1)));
    close(open, close_with, opened);
    return {.column = opened, .form = std::move(set)};
  }

  void close(char open, char close_with, std::size_t opened) {
    if (!text_.take(close_with)) {
      text_.fail(fmt::format("'{}' for the '{}' of column {}", close_with, open, opened));
    }
  }

  // One event, if one is written here; C is none.
  std::optional<EventTerm> event() {
    if (const std::optional<EventTypes> types = letter()) {
      return EventTerm{.types = *types};
    }
    if (text_.take('S')) {
      return EventTerm{.types = scattering_events};
    }
    if (text_.at_any("'\"")) {
      return EventTerm{.types = dot_events, .name = name(dot_events)};
    }
    return text_.take('<') ? std::optional(bracketed()) : std::nullopt;
  }

  std::optional<EventTypes> letter() {
    constexpr std::array letters{std::pair{'R', reflection_event}, std::pair{'T', refraction_event},
                                 std::pair{'L', light_event}, std::pair{'O', hit_event},
                                 std::pair{'.', dot_events}};
    for (const auto& [written, types] : letters) {
      if (text_.take(written)) {
        return types;
      }
    }
    return std::nullopt;
  }

  // What is left of <R>, <R.>, <RS>, <R'name'> or <R.'name'>.
  EventTerm bracketed() {
    const std::optional<EventTypes> type = letter();
    if (!type) {
      text_.fail("R, T, L, O or '.' after '<'");
    }
    EventTerm term{.types = *type};
    std::string_view after = "the type";
    std::string_view next = "S, '.', a name or '>'";
    if ((term.types & scattering_events) == 0) {
      if (text_.at_any("S")) {
        text_.fail("'.', a name or '>', since only R and T scatter");
      }
      next = "'.', a name or '>'";
    }
    if (text_.take('S')) {
      term.types &= scattering_events;
      after = "the scattering";
    } else if (text_.take('.')) {
      after = "the scattering";
    }
    if (after == "the scattering") {
      next = "'>'";
    }
    if (text_.at_any("'\"")) {
      term.name = name(term.types);
      after = "the name";
      next = "'>'";
    }
    if (!text_.take('>')) {
      text_.fail(fmt::format("{} after {}", next, after));
    }
    return term;
  }

  NameClass name(EventTypes types) {
    const std::size_t column = text_.column();
    std::string name = text_.quoted_name();
    const auto known = std::ranges::find(syntax_.names, name);
    const auto place = static_cast<NameClass>(known - syntax_.names.begin());
    if (known == syntax_.names.end()) {
      syntax_.names.push_back(std::move(name));
    }
    syntax_.uses.push_back({.name = place + 1, .types = types, .column = column});
    return place + 1;
  }

  PathText text_;
  PathSyntax syntax_;
  int nesting_ = 0;
};

}  // namespace

PathSyntax parse(std::string_view text) {
  if (text.size() > most_text) {
    throw PathError(most_text + 1, fmt::format("expected the end: an expression has at most {} "
                                               "characters, found {}",
                                               most_text, text.size()));
  }
  PathSyntax syntax = Parser(text).parse();
  require_camera_first(syntax.expression);
  return syntax;
}

}  // namespace raycat::paths
