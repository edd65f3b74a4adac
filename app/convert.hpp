#pragma once

#include <optional>
#include <string>

#include "app/options.hpp"
#include "app/view.hpp"

namespace raycat::app {

/// What `raycat convert` was asked for.
struct ConvertOptions {
  CommonOptions common;
  ViewOptions view;  ///< of formats that hold a camera
  std::string out;
  // In half diagonals of the object, and of triangles alone:
  std::optional<double> chord_error;     ///< of what curved surfaces become
  std::optional<double> simplify_error;  ///< by which triangles are made fewer; none if not
};

}  // namespace raycat::app
