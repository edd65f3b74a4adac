#include "app/convert.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/pov_file.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

// Writes the scene, adds to its warnings what the format cannot hold, and tells its figures.
using Writer = Json (*)(const ConvertOptions& options, SceneFile& file);

Json to_pov(const ConvertOptions& options, SceneFile& file) {
  const ImageSize size = parse_size(options.view.size);
  const Camera camera = lit_view(file, options.view, size);
  const std::vector<std::string> left_out = write_pov(options.out, file.scene,
                                                      {.camera = camera,
                                                       .width = size.width,
                                                       .height = size.height,
                                                       .levels = options.view.levels});
  file.warnings.insert(file.warnings.end(), left_out.begin(), left_out.end());
  return {{"objects", file.scene.surfaces.objects()}, {"lights", file.scene.lights.size()}};
}

struct Format {
  std::string_view extension;
  Writer write;
};

constexpr std::array formats{Format{".pov", to_pov}};

const Format& format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  std::string known;
  for (const Format& format : formats) {
    if (format.extension == extension) {
      return format;
    }
    known += fmt::format("{}{}", known.empty() ? "" : ", ", format.extension);
  }
  throw UsageError(
      fmt::format("{}: unknown kind of file to convert to: the name must end in {}", path, known));
}

void require_place(const ConvertOptions& options) {
  std::error_code ignored;
  if (std::filesystem::equivalent(options.out, options.common.scene, ignored)) {
    throw UsageError(fmt::format("{}: the output would overwrite the scene", options.out));
  }
  require_writable(options.out);
}

void convert(const ConvertOptions& options) {
  const Format& format = format_of(options.out);
  require_place(options);
  SceneFile file = load(options.common);
  Json figures{{"out", options.out}};
  figures.update(format.write(options, file));
  if (!options.common.quiet) {
    warn(file.warnings);
  }
  if (options.common.json) {
    print(dump(figures));
  }
}

}  // namespace

void add_convert(CLI::App& app) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert", "Write a scene for other programs: .pov for POV-Ray");
  add_common(*command, options->common);
  command->add_option("-o,--out", options->out, "The file, its kind told by its extension: .pov")
      ->type_name("FILE")
      ->required();
  add_view(*command, options->view);
  command->callback([options] { convert(*options); });
}

}  // namespace raycat::app
