#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "categories/category_trees.hpp"
#include "raytree/surface_table.hpp"

namespace raycat {

/// What two ray trees differ by, and where: one bit each.
enum class EdgeClass : std::uint8_t {
  object = 1,       ///< silhouette: different objects, or a node that only one tree has
  primitive = 2,    ///< different primitives of one object
  face = 4,         ///< different faces of one primitive
  shadow = 8,       ///< one surface under different lights
  reflection = 16,  ///< the way to the node holds a reflection
  refraction = 32   ///< the way to the node holds a refraction
};

inline constexpr std::array all_edge_classes{EdgeClass::object,     EdgeClass::primitive,
                                             EdgeClass::face,       EdgeClass::shadow,
                                             EdgeClass::reflection, EdgeClass::refraction};

constexpr std::uint8_t bit(EdgeClass edge_class) noexcept {
  return static_cast<std::uint8_t>(edge_class);
}

/// object, primitive, face, shadow, reflection or refraction.
std::string_view name(EdgeClass edge_class);

/// How the trees of an image's pixels differ from their neighbours'.
struct EdgeClasses {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> masks;  ///< bits of `EdgeClass`, 0 off edges; rows from the top

  /// Pixels that have each class, in the order of `all_edge_classes`.
  std::array<std::uint64_t, all_edge_classes.size()> counts() const;
};

/// Compares the tree of each pixel with those of its three neighbours of the edge test (Section 3,
/// Fig. 6a), and unites what these comparisons find. Two trees are compared node by node from the
/// root down, and what counts are the differences of the first level that has any: those below
/// most often only follow from them. So a mask is 0 exactly where `detect_edges` finds no edge.
///
/// The surface after the last of `surfaces` is one that a path expression leaves untold; it differs
/// from all others by object. Throws `std::logic_error` as `CategoryTrees` does.
EdgeClasses classify_edges(CategoryTrees& trees, const SurfaceTable& surfaces);

}  // namespace raycat
