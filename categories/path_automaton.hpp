#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "categories/path_graph.hpp"
#include "raytree/ray_tree.hpp"

namespace raycat::paths {

inline constexpr std::size_t most_states = 4096;     ///< of an automaton
inline constexpr std::size_t most_arrivals = 16384;  ///< its states times its name classes

/// A path expression as a deterministic automaton. It is in a state on the way to each hit, and
/// what it does there depends on the class of the object that is hit: all of this is one `Arrival`.
class Automaton {
 public:
  using State = std::uint32_t;
  static constexpr State dead = 0;   ///< nothing from here on is accepted
  static constexpr State start = 1;  ///< on the way from the camera to the first hit

  struct Arrival {
    LightMask lights = 0;  ///< those whose words are accepted
    bool surface = false;  ///< is the word of the hit accepted?

    /// On the way on: [0] where the ray is refracted, [1] where it is reflected, as the last bit of
    /// the heap position has it.
    std::array<State, 2> next{dead, dead};
  };

  /// `lights` are those of each class. Throws `PathError` if that takes more than `most_states` or
  /// `most_arrivals`, and if no path at all is accepted.
  Automaton(const Graph& graph, std::span<const LightMask> lights);

  const Arrival& arrive(State state, NameClass object) const {
    return arrivals_[state * classes_ + object];
  }

 private:
  std::size_t classes_;
  std::vector<Arrival> arrivals_;  ///< by state, then class
};

}  // namespace raycat::paths
