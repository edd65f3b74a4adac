#include "categories/path_graph.hpp"

#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "categories/path_error.hpp"

namespace raycat::paths {
namespace {

using State = Graph::State;
using Index = Graph::Index;

std::vector<EventTypes> label_of(const EventSet& set, std::size_t classes) {
  std::vector<EventTypes> types(classes, 0);
  for (const EventTerm& term : set.terms) {
    for (std::size_t k = 0; k < classes; ++k) {
      if (!term.name || *term.name == k) {
        types[k] |= term.types;
      }
    }
  }
  if (set.excluded) {
    for (EventTypes& matched : types) {
      matched = static_cast<EventTypes>(dot_events & ~matched);
    }
  }
  return types;
}

// Builds backwards: each part is given the state that comes after it, and returns its first.
class Builder {
 public:
  explicit Builder(std::size_t classes) : classes_(classes) {}

  Graph build(const PathNode& expression) {
    graph_.start = before(expression, 0);
    return std::move(graph_);
  }

 private:
  Index before(const PathNode& node, Index next) {
    return std::visit([&](const auto& form) { return before(form, next); }, node.form);
  }

  Index before(const CameraEvent&, Index next) {
    return add_event({.kind = State::Kind::camera, .next = next});
  }

  // Repeated, the same set gets the same label.
  Index before(const EventSet& set, Index next) {
    const auto [label, fresh] = labels_.emplace(&set, graph_.labels.size());
    if (fresh) {
      graph_.labels.push_back(label_of(set, classes_));
    }
    return add_event({.kind = State::Kind::event, .label = label->second, .next = next});
  }

  Index before(const Sequence& sequence, Index next) {
    for (std::size_t i = sequence.parts.size(); i-- > 0;) {
      next = before(sequence.parts[i], next);
    }
    return next;
  }

  Index before(const Choice& choice, Index next) {
    Index first = before(choice.parts.front(), next);
    for (std::size_t i = 1; i < choice.parts.size(); ++i) {
      first = fork(first, before(choice.parts[i], next));
    }
    return first;
  }

  Index before(const Repetition& repetition, Index next) {
    const PathNode& part = repetition.part.front();
    Index first = next;
    if (!repetition.most) {
      const Index again = fork(0, next);
      const Index once = before(part, again);
      graph_.states[again].next = once;
      first = again;
    } else {
      for (int i = repetition.least; i < *repetition.most; ++i) {
        first = fork(before(part, first), next);
      }
    }
    for (int i = 0; i < repetition.least; ++i) {
      first = before(part, first);
    }
    return first;
  }

  Index fork(Index next, Index other) {
    return add({.kind = State::Kind::fork, .next = next, .other = other});
  }

  Index add_event(const State& state) {
    if (++events_ > most_events) {
      throw PathError(1, fmt::format("the expression has more than {} events, counting how often "
                                     "each is repeated: expected a simpler one",
                                     most_events));
    }
    return add(state);
  }

  Index add(const State& state) {
    graph_.states.push_back(state);
    return static_cast<Index>(graph_.states.size() - 1);
  }

  Graph graph_;
  std::size_t classes_;
  std::size_t events_ = 0;
  std::unordered_map<const EventSet*, Index> labels_;
};

}  // namespace

Graph graph_of(const PathSyntax& syntax) {
  return Builder(syntax.classes()).build(syntax.expression);
}

}  // namespace raycat::paths
