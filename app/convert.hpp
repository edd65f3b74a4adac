#pragma once

#include <string>

#include "app/options.hpp"
#include "app/view.hpp"

namespace raycat::app {

/// What `raycat convert` was asked for.
struct ConvertOptions {
  CommonOptions common;
  ViewOptions view;  ///< of formats that hold a camera
  std::string out;
  double chord_error = 1e-3;  ///< of what curved surfaces become, in half diagonals of the object
};

}  // namespace raycat::app
