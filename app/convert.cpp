#include "app/convert.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/report.hpp"
#include "io/export/glb_file.hpp"
#include "io/export/obj_file.hpp"
#include "io/export/object_mesh.hpp"
#include "io/export/ply_file.hpp"
#include "io/export/simplify.hpp"
#include "io/export/stl_file.hpp"
#include "io/files/input_file.hpp"
#include "io/files/output_file.hpp"
#include "io/povray/file.hpp"
#include "io/scene/default_view.hpp"

namespace raycat::app {
namespace {

using Json = nlohmann::ordered_json;

// Writes the scene, adds to its warnings what the format cannot hold, and tells its figures.
using Writer = Json (*)(const ConvertOptions& options, SceneFile& file);

Json to_pov(const ConvertOptions& options, SceneFile& file) {
  const ImageSize size = parse_size(options.view.size);
  const Camera camera = camera_of(file, options.view, size);
  file.scene = lit(std::move(file.scene), camera);
  const std::vector<std::string> left_out = write_pov(options.out, file.scene,
                                                      {.camera = camera,
                                                       .width = size.width,
                                                       .height = size.height,
                                                       .levels = options.view.levels});
  file.warnings.insert(file.warnings.end(), left_out.begin(), left_out.end());
  return {{"objects", file.scene.surfaces.objects()}, {"lights", file.scene.lights.size()}};
}

void warn_of_absent(const std::vector<ObjectMesh>& objects, SceneFile& file) {
  const std::vector<std::string> lines = without_parts(file.scene.surfaces, objects);
  file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
}

// Triangles for formats that know nothing else.
template <typename Write>
Json to_mesh(const ConvertOptions& options, SceneFile& file, Write&& write) {
  constexpr double chord_error = 1e-3;
  std::vector<ObjectMesh> objects =
      object_meshes(file.scene, options.chord_error.value_or(chord_error));
  if (options.simplify_error) {
    const std::vector<std::string> lines =
        simplify(file.scene.surfaces, objects, *options.simplify_error);
    file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
  }
  std::size_t triangles = 0;
  std::size_t written = 0;
  for (const ObjectMesh& object : objects) {
    written += object.parts.empty() ? 0U : 1U;
    for (const ObjectMesh::Part& part : object.parts) {
      triangles += part.mesh.triangles.triangles.size();
    }
  }
  if (triangles == 0) {
    throw UsageError(
        fmt::format("{}: holds no surface that can be made of triangles", options.common.scene));
  }
  write(objects);
  return {{"objects", written}, {"triangles", triangles}};
}

Json to_glb(const ConvertOptions& options, SceneFile& file) {
  return to_mesh(options, file, [&](const std::vector<ObjectMesh>& objects) {
    write_glb(options.out, file.scene, objects, file.warnings);
  });
}

Json to_obj(const ConvertOptions& options, SceneFile& file) {
  return to_mesh(options, file, [&](const std::vector<ObjectMesh>& objects) {
    warn_of_absent(objects, file);
    write_obj(options.out, file.scene.surfaces, objects);
  });
}

Json to_ply(const ConvertOptions& options, SceneFile& file) {
  return to_mesh(options, file, [&](const std::vector<ObjectMesh>& objects) {
    warn_of_absent(objects, file);
    write_ply(options.out, file.scene.surfaces, objects);
  });
}

Json to_stl(const ConvertOptions& options, SceneFile& file) {
  return to_mesh(options, file, [&](const std::vector<ObjectMesh>& objects) {
    warn_of_absent(objects, file);
    write_stl(options.out, objects);
  });
}

struct Format {
  std::string_view extension;
  Writer write;
  bool triangles = true;
};

constexpr std::array formats{Format{".glb", to_glb}, Format{".obj", to_obj}, Format{".ply", to_ply},
                             Format{".pov", to_pov, false}, Format{".stl", to_stl}};

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

// Throws `UsageError` for what has no effect on the format.
void require_effect(const ConvertOptions& options, const Format& format) {
  if (!format.triangles && (options.chord_error || options.simplify_error)) {
    throw UsageError(fmt::format("{}: {} is of triangles, which a {} file has none of", options.out,
                                 options.chord_error ? "--chord" : "--simplify", format.extension));
  }
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
  require_effect(options, format);
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
      app.add_subcommand("convert",
                         "Write a scene for other programs: as triangles that know their faces, or "
                         "for POV-Ray");
  add_common(*command, options->common);
  command
      ->add_option("-o,--out", options->out,
                   "The file, its kind told by its extension: .glb .obj .ply .stl .pov")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--chord", options->chord_error,
                   "How far triangles may be from curved surfaces, in half diagonals of the "
                   "object; 0.001 by default")
      ->type_name("E")
      ->check(number_in(1e-5, 0.5));
  command
      ->add_option("--simplify", options->simplify_error,
                   "Take vertices out where the surface moves by no more than this, in half "
                   "diagonals of the object; borders between faces stay")
      ->type_name("E")
      ->check(number_in(1e-9, 0.5));
  add_view(*command, options->view);
  command->callback([options] { convert(*options); });
}

}  // namespace raycat::app
