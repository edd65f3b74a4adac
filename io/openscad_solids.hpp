#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/placed_shape.hpp"
#include "io/openscad_parser.hpp"

namespace raycat::openscad {

enum class Kind : std::uint8_t { unite, intersect, subtract, solid, flat };

/// What a node of the file comes to.
struct Item {
  Kind kind = Kind::unite;
  bool alive = false;               ///< is it part of the scene's geometry?
  bool subtracted = false;          ///< an odd number of times
  bool top = false;                 ///< are it and all nodes above it unions?
  std::uint32_t solid = 0;          ///< of alive solids, index into `Solids::shapes`
  std::optional<glm::vec3> colour;  ///< sRGB, as in the file
  Bounds bounds;                    ///< of alive nodes; no smaller than the geometry
};

struct Solids {
  std::vector<Item> items;  ///< one a node
  std::vector<PlacedShape> shapes;
  std::uint32_t root = 0;  ///< the node that is the scene: the file, or the one marked with !
};

/// Works out which nodes have geometry, by OpenSCAD's rules: `*` and `%` nodes are left out, a
/// difference whose first operand is empty is empty, an intersection with an empty operand is
/// empty, and the first operand says whether an operation is in two or three dimensions. Throws
/// `LoadError` for nodes that are unknown, not supported, or have bad parameters.
Solids evaluate(const std::filesystem::path& file, const File& parsed,
                std::vector<std::string>& warnings);

}  // namespace raycat::openscad
