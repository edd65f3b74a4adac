#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Path expressions as they are written: what the parser makes and the automaton is made from.
namespace raycat::paths {

/// Kinds of events, as bits, so that a set of them is one number.
using EventTypes = std::uint8_t;
inline constexpr EventTypes reflection_event = 1;   ///< R
inline constexpr EventTypes refraction_event = 2;   ///< T
inline constexpr EventTypes light_event = 4;        ///< L
inline constexpr EventTypes hit_event = 8;          ///< O
inline constexpr EventTypes scattering_events = 3;  ///< S
inline constexpr EventTypes dot_events = 7;         ///< `.`, which never is O

/// The names that an expression mentions sort objects and lights into classes: class k has the name
/// k - 1 of the expression, and class 0 those that it does not mention.
using NameClass = std::uint32_t;

/// Matches events of some types, on anything or on what has one name.
struct EventTerm {
  EventTypes types = 0;
  std::optional<NameClass> name;
};

/// One event that one of `terms` matches or, if `excluded`, an R, T or L that none of them does.
struct EventSet {
  std::vector<EventTerm> terms;
  bool excluded = false;
};

struct PathNode;

struct CameraEvent {};

struct Sequence {
  std::vector<PathNode> parts;
};

struct Choice {
  std::vector<PathNode> parts;
};

struct Repetition {
  std::vector<PathNode> part;  ///< one
  int least = 0;
  std::optional<int> most;  ///< none: no limit
};

struct PathNode {
  std::size_t column = 1;  ///< where it begins
  bool optional = false;   ///< can match nothing
  std::variant<CameraEvent, EventSet, Sequence, Choice, Repetition> form;
};

/// One place where an expression mentions a name.
struct NameUse {
  NameClass name = 0;
  EventTypes types = 0;    ///< of what it should be the name
  std::size_t column = 1;  ///< of its opening quote
};

struct PathSyntax {
  PathNode expression;
  std::vector<std::string> names;  ///< distinct; that of class k at k - 1
  std::vector<NameUse> uses;       ///< in the order of their columns

  std::size_t classes() const noexcept { return names.size() + 1; }
};

}  // namespace raycat::paths
