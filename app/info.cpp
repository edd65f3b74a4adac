#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/report.hpp"
#include "io/scene/closed_scene.hpp"

namespace raycat::app {
namespace {

nlohmann::ordered_json summary(const SceneFile& file) {
  const Scene& scene = file.scene;
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  for (const Camera& camera : scene.cameras) {
    cameras.push_back(camera.name);
  }
  return {{"objects", scene.surfaces.objects()},
          {"primitives", scene.surfaces.primitives()},
          {"faces", scene.surfaces.faces()},
          {"triangles", file.triangles},
          {"csg_nodes", file.csg_nodes},
          {"materials", scene.materials.size()},
          {"textures", scene.textures.size()},
          {"lights", scene.lights.size()},
          {"cameras", cameras},
          {"bounds", to_json(bounds(scene))},
          {"closed", is_closed(scene)},
          {"extensions", file.extensions},
          {"warnings", file.warnings}};
}

std::string text_of(const nlohmann::ordered_json& value) {
  if (value.is_string()) {
    return printable(value.get<std::string>());
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "yes" : "no";
  }
  if (value.is_array()) {
    std::string text;
    for (const auto& item : value) {
      text += (text.empty() ? "" : ", ") + text_of(item);
    }
    return text.empty() ? "none" : text;
  }
  if (value.is_object()) {
    return fmt::format("{} to {}", dump(value["min"]), dump(value["max"]));
  }
  return value.is_null() ? "none" : dump(value);
}

void info(const CommonOptions& options) {
  SceneFile file = load(options);
  const bool is_seen = file.scene.surfaces.faces() > 0;
  if (is_seen && file.scene.lights.empty()) {
    file.warnings.emplace_back("no light in the file: a headlight and a key light are used");
  }
  if (is_seen && file.scene.cameras.empty()) {
    file.warnings.emplace_back("no camera in the file: the scene is framed automatically");
  }
  const nlohmann::ordered_json all = summary(file);
  if (options.json) {
    print(dump(all));
    return;
  }
  for (const auto& [key, value] : all.items()) {
    if (key != "warnings") {
      print(fmt::format("{:<12}{}", key, text_of(value)));
    }
  }
  if (!options.quiet) {
    warn(file.warnings);
  }
}

}  // namespace

void add_info(CLI::App& app) {
  auto options = std::make_shared<CommonOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a scene file holds");
  add_common(*command, *options);
  command->callback([options] { info(*options); });
}

}  // namespace raycat::app
