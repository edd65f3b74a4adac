#include "app/probe.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "app/command.hpp"
#include "app/report.hpp"

namespace raycat::app {

std::string surface_name(const SurfaceTable& surfaces, SurfaceId surface) {
  const std::string& object = surfaces.name(surfaces.object(surface));
  const std::string& primitive = surfaces.name(surfaces.primitive(surface));
  return fmt::format(
      "{} face {}",
      printable(object == primitive ? object : fmt::format("{} / {}", object, primitive)),
      surfaces.face_in_primitive(surface));
}

namespace {

void probe(const ProbeOptions& options) {
  if (options.pixel.empty() == options.rays.empty()) {
    throw UsageError("probe: give either --pixel X,Y or --rays FILE");
  }
  SceneFile file = load(options.common);
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  if (!options.pixel.empty()) {
    probe_pixel(options, std::move(file));
  } else if (options.rays == "-") {
    probe_rays(options, file, std::cin);
  } else {
    std::ifstream in(options.rays);
    if (!in || std::filesystem::is_directory(options.rays)) {
      throw UsageError(fmt::format("{}: cannot be read: expected a file of rays", options.rays));
    }
    probe_rays(options, file, in);
  }
}

}  // namespace

void add_probe(CLI::App& app) {
  auto options = std::make_shared<ProbeOptions>();
  CLI::App* command =
      app.add_subcommand("probe", "Show the ray tree of a pixel, or what given rays cross");
  add_common(*command, options->common);
  add_view(*command, options->view);
  add_detail(*command, options->detail);
  command
      ->add_option("--pixel", options->pixel,
                   "Show the ray tree of this pixel and its category under every method")
      ->type_name("X,Y");
  command
      ->add_option("--rays", options->rays,
                   "List the crossings of each ray of a file, or of stdin with -: lines ox oy oz "
                   "dx dy dz; t counts from 0 on in units of the direction")
      ->type_name("FILE");
  command->callback([options] { probe(*options); });
}

}  // namespace raycat::app
