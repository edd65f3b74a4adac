#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace raycat::openscad {

/// What a node does with its children, or that it is made of its parameters alone.
enum class Kind : std::uint8_t {
  unite,  ///< also group, multmatrix, color and render
  intersect,
  subtract,
  resize,  ///< unites, and stretches the union
  hull,
  minkowski,
  extrude,  ///< from two dimensions to three
  project,  ///< from three dimensions to two
  flatten,  ///< offset and fill, within two dimensions
  solid,    ///< cube, sphere, cylinder, polyhedron
  flat,     ///< square, circle, polygon, text
  file      ///< import, surface
};

/// Of the node called `name`; nothing if there is none such.
std::optional<Kind> kind_of(std::string_view name);

/// Is it without operands?
constexpr bool is_primitive(Kind kind) {
  return kind == Kind::solid || kind == Kind::flat || kind == Kind::file;
}

/// Do its operands stay parts of it, in one CSG tree?
constexpr bool is_set_operation(Kind kind) {
  return kind == Kind::unite || kind == Kind::intersect || kind == Kind::subtract ||
         kind == Kind::resize;
}

}  // namespace raycat::openscad
