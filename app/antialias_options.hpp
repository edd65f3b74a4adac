#pragma once

#include <optional>

#include "antialias/antialias.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace raycat::app {

enum class AntialiasMethod { uniform, threshold, whitted, category, adaptive };

/// How a picture is to be antialiased.
struct AntialiasOptions {
  std::optional<AntialiasMethod> method;
  std::optional<int> samples;
  std::optional<float> threshold;
  std::optional<float> quality;
  std::optional<double> budget;
  std::optional<Filter> filter;
  bool by_area = false;
  bool recursive = false;
  bool colour_only = false;
};

void add_antialias(CLI::App& command, AntialiasOptions& options);

/// Throws `UsageError` for options that the method has no use for.
void require_antialias(const AntialiasOptions& options);

/// The picture by the method, which must be there, and with the filter of the options.
AntialiasedPicture antialias(Sampler& sampler, AntialiasSettings settings,
                             const AntialiasOptions& options);

}  // namespace raycat::app
