#pragma once

#include <cstdint>
#include <vector>

#include "categories/path_syntax.hpp"

namespace raycat::paths {

/// A path expression as a nondeterministic automaton (Thompson's construction). State 0 accepts.
struct Graph {
  using Index = std::uint32_t;

  struct State {
    enum class Kind : std::uint8_t { accept, camera, event, fork };

    Kind kind = Kind::accept;
    Index label = 0;  ///< of an event: which of `labels` leads to `next`
    Index next = 0;
    Index other = 0;  ///< of a fork, which leads to both without an event
  };

  std::vector<State> states{1};
  Index start = 0;

  /// What events match: by the class of what they happen at, the types.
  std::vector<std::vector<EventTypes>> labels;
};

inline constexpr std::size_t most_events = 512;  ///< of an expression, counting repetitions

/// Throws `PathError` past `most_events`.
Graph graph_of(const PathSyntax& syntax);

}  // namespace raycat::paths
