#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "io/scene_file.hpp"

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

/// Adds the arguments of `options` to `command`.
void add_common(CLI::App& command, CommonOptions& options);

/// Reads the scene of `options`.
SceneFile load(const CommonOptions& options);

/// Each adds its subcommand to `app`; the parser then calls it.
void add_render(CLI::App& app);
void add_info(CLI::App& app);
void add_probe(CLI::App& app);

}  // namespace raycat::app
