#pragma once

#include <iosfwd>
#include <string>

#include "app/detail_options.hpp"
#include "app/options.hpp"
#include "app/view.hpp"

namespace raycat::app {

struct ProbeOptions {
  CommonOptions common;
  ViewOptions view;
  DetailOptions detail;
  std::string pixel;
  std::string rays;
};

/// Prints the ray tree of a pixel and its category under every method.
void probe_pixel(const ProbeOptions& options, SceneFile file);

/// Prints what each ray of `in` crosses: lines ox oy oz dx dy dz.
void probe_rays(const ProbeOptions& options, const SceneFile& file, std::istream& in);

/// Object, primitive where it has another name, and face, for a terminal.
std::string surface_name(const SurfaceTable& surfaces, SurfaceId face);

}  // namespace raycat::app
