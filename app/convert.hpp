#pragma once

#include <string>

#include "app/command.hpp"
#include "app/view.hpp"

namespace raycat::app {

/// What `raycat convert` was asked for.
struct ConvertOptions {
  CommonOptions common;
  ViewOptions view;  ///< of formats that hold a camera
  std::string out;
};

}  // namespace raycat::app
