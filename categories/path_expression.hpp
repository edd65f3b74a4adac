#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "categories/path_automaton.hpp"
#include "categories/path_error.hpp"
#include "categories/path_names.hpp"
#include "categories/path_syntax.hpp"
#include "raytree/ray_tree.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// Stands for the surface of a node of which a path expression accepts the lights only.
inline constexpr SurfaceId untold{~std::uint32_t{0}};

/// Says which part of ray trees counts, in the notation of light path expressions
/// (docs/path-expressions.md). The word of a hit is C for the camera and then an event for each
/// surface on the way: R where the ray was reflected, T where it was refracted. The word of a
/// light on a hit is the word of the hit, then L. At each hit, a word may also have an O that names
/// what is hit. A hit's surface counts if its word is accepted, and a light if its word is.
/// Compiled to a deterministic automaton, so that a step down the tree is a table lookup.
class PathExpression {
 public:
  /// Names in quotes are those of objects of `surfaces` and of `lights`, in the order of their
  /// bits; bits past them are lights without a name. Throws `PathError` for what cannot be read,
  /// for a name that nothing has, for what no path can match, and for what is too large.
  PathExpression(std::string_view text, const SurfaceTable& surfaces,
                 std::span<const std::string> lights);

  /// Reduces `tree`, whose surfaces are faces, to what is accepted: lights that are not are
  /// cleared, the surface of a node that is accepted for its lights alone becomes `untold`, and
  /// nodes of which nothing is left are dropped. So are nodes whose parent is not in the tree,
  /// since their words are not known. `surfaces` are those of the constructor. Allocates nothing.
  void filter(RayTree& tree, const SurfaceTable& surfaces) const;

 private:
  PathExpression(const paths::PathSyntax& syntax, const SurfaceTable& surfaces,
                 std::span<const std::string> lights);
  PathExpression(const paths::PathSyntax& syntax, paths::Classes classes);

  std::vector<paths::NameClass> class_of_object_;
  paths::Automaton automaton_;
};

}  // namespace raycat
