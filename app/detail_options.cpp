#include "app/detail_options.hpp"

#include <fmt/format.h>

#include "app/command.hpp"
#include "app/help.hpp"

namespace raycat::app {

void add_detail(CLI::App& command, DetailOptions& options) {
  start_group(command, groups::categories);
  add_choice<Granularity>(
      command, "--ids", options.detail.ids,
      {{"object", Granularity::object},
       {"primitive", Granularity::primitive},
       {"face", Granularity::face}},
      "What counts as a surface of its own: object, primitive or face (default)")
      ->type_name("IDS");
  command
      .add_option("--category-levels", options.detail.levels,
                  "Levels of the ray tree that categories keep; all by default")
      ->type_name("N")
      ->check(CLI::Range(1, most_levels));
  add_choice<LightDetail>(
      command, "--lights", options.lights,
      {{"on", LightDetail::on}, {"off", LightDetail::off}, {"visible", LightDetail::visible}},
      "Do categories tell which visible lights there are: on (default), where the material lets "
      "them show, visible, whatever the material, or off")
      ->type_name("on|off|visible");
  command
      .add_option("--min-weight", options.detail.min_weight,
                  "Categories drop nodes that can only count for less than this in the pixel")
      ->type_name("W")
      ->check(number_in(0.0, 1.0));
  command
      .add_option("--paths", options.paths,
                  "Categories keep what this path expression accepts, such as 'C<R.>.*' for what "
                  "is seen in mirrors; see docs/path-expressions.md")
      ->type_name("EXPR");
  add_choice<bool>(command, "--textures", options.mark_textures,
                   {{"mark", true}, {"ignore", false}},
                   "Pixels that meet a texture: mark (default) or ignore them")
      ->type_name("mark|ignore");
}

CountedLights counted_lights(const DetailOptions& options) {
  return options.lights == LightDetail::visible ? CountedLights::visible : CountedLights::lighting;
}

Detail detail_for(const DetailOptions& options, const Scene& scene) {
  Detail detail = options.detail;
  detail.lights = options.lights != LightDetail::off;
  if (!options.paths) {
    return detail;
  }
  std::vector<std::string> lights;
  for (const Light& light : scene.lights) {
    lights.push_back(light.name);
  }
  try {
    detail.paths = std::make_shared<const PathExpression>(*options.paths, scene.surfaces, lights);
  } catch (const PathError& error) {
    throw UsageError(fmt::format("--paths {}: {}", *options.paths, error.what()));
  }
  return detail;
}

}  // namespace raycat::app
