#pragma once

#include <span>
#include <string>
#include <vector>

#include "categories/path_syntax.hpp"
#include "raytree/ray_tree.hpp"
#include "raytree/surface_table.hpp"

namespace raycat::paths {

/// The objects and lights of a scene, sorted by the names that an expression mentions.
struct Classes {
  std::vector<NameClass> of_object;  ///< by object id
  std::vector<LightMask> lights;     ///< by class; bits without a light are of class 0
};

/// Throws `PathError` for the first name that nothing it could stand for has, and
/// `std::length_error` past `most_lights` lights.
Classes classify(const PathSyntax& syntax, const SurfaceTable& surfaces,
                 std::span<const std::string> lights);

}  // namespace raycat::paths
