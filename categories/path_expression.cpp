#include "categories/path_expression.hpp"

#include <array>
#include <cassert>

#include "categories/path_graph.hpp"
#include "categories/path_parser.hpp"

namespace raycat {

PathExpression::PathExpression(std::string_view text, const SurfaceTable& surfaces,
                               std::span<const std::string> lights)
    : PathExpression(paths::parse(text), surfaces, lights) {}

PathExpression::PathExpression(const paths::PathSyntax& syntax, const SurfaceTable& surfaces,
                               std::span<const std::string> lights)
    : PathExpression(syntax, paths::classify(syntax, surfaces, lights)) {}

PathExpression::PathExpression(const paths::PathSyntax& syntax, paths::Classes classes)
    : class_of_object_(std::move(classes.of_object)),
      automaton_(paths::graph_of(syntax), classes.lights) {}

// Backwards, parents come before their children. What was met last on each level are then the
// nodes above the one at hand, if they are in the tree at all.
void PathExpression::filter(RayTree& tree, const SurfaceTable& surfaces) const {
  using paths::Automaton;
  static constexpr Automaton::Arrival nothing;
  struct Met {
    HeapPosition position = 0;
    const Automaton::Arrival* arrival = &nothing;
  };
  std::array<Met, most_levels + 1> met;  // by level
  auto kept = tree.end();
  for (auto node = tree.end(); node != tree.begin();) {
    --node;
    assert(node->position >= root);
    const auto here = static_cast<std::size_t>(level(node->position));
    Automaton::State state = Automaton::start;
    if (node->position != root) {
      const Met& parent = met[here - 1];
      const bool known = parent.position == node->position / 2;
      state = known ? parent.arrival->next[node->position % 2] : Automaton::dead;
    }
    met[here] = {.position = node->position};
    if (state == Automaton::dead) {
      continue;
    }
    const auto object = static_cast<std::size_t>(surfaces.object(node->surface));
    const Automaton::Arrival& arrival = automaton_.arrive(state, class_of_object_[object]);
    met[here].arrival = &arrival;
    const LightMask lights = node->lights & arrival.lights;
    if (arrival.surface || lights != 0) {
      --kept;
      *kept = *node;
      kept->lights = lights;
      kept->surface = arrival.surface ? node->surface : untold;
    }
  }
  tree.erase(tree.begin(), kept);
}

}  // namespace raycat
