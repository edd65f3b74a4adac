#include "categories/path_automaton.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "categories/path_error.hpp"

namespace raycat::paths {
namespace {

using Index = Graph::Index;
using Kind = Graph::State::Kind;

// States of the graph at once, forks left out, ascending.
using Subset = std::vector<Index>;

// Finds subsets, following forks as far as they lead.
class Steps {
 public:
  explicit Steps(const Graph& graph) : graph_(graph), seen_(graph.states.size(), 0) {}

  void begin() {
    ++round_;
    found_.clear();
  }

  void add(Index from) {
    pending_.push_back(from);
    while (!pending_.empty()) {
      const Index at = pending_.back();
      pending_.pop_back();
      if (std::exchange(seen_[at], round_) == round_) {
        continue;
      }
      const Graph::State& state = graph_.states[at];
      if (state.kind == Kind::fork) {
        pending_.push_back(state.next);
        pending_.push_back(state.other);
      } else {
        found_.push_back(at);
      }
    }
  }

  // Adds what `from` reaches by an event of type `type` at something of class `at`.
  void add_after(const Subset& from, EventTypes type, NameClass at) {
    for (const Index index : from) {
      const Graph::State& state = graph_.states[index];
      if (state.kind == Kind::event && (graph_.labels[state.label][at] & type) != 0) {
        add(state.next);
      }
    }
  }

  const Subset& found() {
    std::ranges::sort(found_);
    return found_;
  }

 private:
  const Graph& graph_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t round_ = 0;
  std::vector<Index> pending_;
  Subset found_;
};

bool accepts(const Subset& subset) { return !subset.empty() && subset.front() == 0; }

class Builder {
 public:
  using State = Automaton::State;
  using Arrival = Automaton::Arrival;

  Builder(const Graph& graph, std::span<const LightMask> lights)
      : graph_(graph), classes_(lights.size()), steps_(graph) {
    std::vector<LightMask> of_label;
    for (const std::vector<EventTypes>& label : graph.labels) {
      LightMask& mask = of_label.emplace_back(0);
      for (std::size_t k = 0; k < classes_; ++k) {
        mask |= (label[k] & light_event) != 0 ? lights[k] : 0;
      }
    }
    for (const Graph::State& state : graph.states) {
      steps_.begin();
      steps_.add(state.next);
      const bool last = state.kind == Kind::event && accepts(steps_.found());
      lights_of_last_.push_back(last ? of_label[state.label] : 0);
    }
  }

  std::vector<Arrival> build() {
    number({});
    number(after_camera());
    std::vector<Arrival> arrivals;
    for (State state = 0; state < states_.size(); ++state) {  // finds more as it goes
      for (NameClass k = 0; k < classes_; ++k) {
        arrivals.push_back(arrival(*subsets_[state], k));
      }
    }
    return arrivals;
  }

 private:
  Subset after_camera() {
    steps_.begin();
    steps_.add(graph_.start);
    const Subset first = steps_.found();
    steps_.begin();
    for (const Index index : first) {
      if (graph_.states[index].kind == Kind::camera) {
        steps_.add(graph_.states[index].next);
      }
    }
    return steps_.found();
  }

  // At a hit the word so far can be read as it is, or with the O of what is hit.
  Arrival arrival(const Subset& way, NameClass object) {
    steps_.begin();
    steps_.add_after(way, hit_event, object);
    Subset here;
    std::ranges::set_union(way, steps_.found(), std::back_inserter(here));
    Arrival arrival{.lights = lights(here), .surface = accepts(here)};
    for (const auto& [branch, type] :
         {std::pair(0u, refraction_event), std::pair(1u, reflection_event)}) {
      steps_.begin();
      steps_.add_after(here, type, object);
      arrival.next[branch] = number(steps_.found());
    }
    return arrival;
  }

  LightMask lights(const Subset& here) const {
    LightMask mask = 0;
    for (const Index index : here) {
      mask |= lights_of_last_[index];
    }
    return mask;
  }

  State number(const Subset& subset) {
    const auto [place, fresh] = states_.emplace(subset, static_cast<State>(states_.size()));
    if (fresh) {
      subsets_.push_back(&place->first);
      if (states_.size() > most_states) {
        throw PathError(1, fmt::format("the expression takes an automaton of more than {} states: "
                                       "expected a simpler one",
                                       most_states));
      }
      if (states_.size() * classes_ > most_arrivals) {
        throw PathError(1, fmt::format("the expression takes an automaton of more than {} states "
                                       "with its {} names: expected a simpler one",
                                       most_arrivals / classes_, classes_ - 1));
      }
    }
    return place->second;
  }

  const Graph& graph_;
  std::size_t classes_;
  Steps steps_;
  std::vector<LightMask> lights_of_last_;  // by state of the graph: what it accepts as the last
  std::map<Subset, State> states_;
  std::vector<const Subset*> subsets_;  // by state
};

// Makes states dead from which nothing is accepted any more, so that what they would lead to need
// not be looked at.
void end_early(std::vector<Automaton::Arrival>& arrivals, std::size_t classes) {
  std::vector<bool> live(arrivals.size() / classes, false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = arrivals.size(); i-- > 0;) {
      const Automaton::Arrival& at = arrivals[i];
      if (!live[i / classes] &&
          (at.surface || at.lights != 0 || live[at.next[0]] || live[at.next[1]])) {
        live[i / classes] = true;
        changed = true;
      }
    }
  }
  if (!live[Automaton::start]) {
    throw PathError(1,
                    "no path matches this expression: C comes first, L last, and O only where "
                    "a surface is hit");
  }
  for (Automaton::Arrival& at : arrivals) {
    for (Automaton::State& next : at.next) {
      next = live[next] ? next : Automaton::dead;
    }
  }
}

}  // namespace

Automaton::Automaton(const Graph& graph, std::span<const LightMask> lights)
    : classes_(lights.size()), arrivals_(Builder(graph, lights).build()) {
  end_early(arrivals_, classes_);
}

}  // namespace raycat::paths
