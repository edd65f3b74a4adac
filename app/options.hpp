#pragma once

#include <stdexcept>
#include <string>

#include "io/scene/scene_file.hpp"

namespace raycat::app {

/// A mistake in the command line or in what is read from the user; exit code 2.
struct UsageError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// What every subcommand takes.
struct CommonOptions {
  std::string scene;
  int threads = 1;
  bool quiet = false;
  bool json = false;
  LoadOptions load;
};

/// Reads the scene of `options`.
SceneFile load(const CommonOptions& options);

}  // namespace raycat::app
