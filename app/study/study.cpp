#include "app/study/study.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/command.hpp"
#include "app/interrupt.hpp"
#include "app/report.hpp"
#include "io/files/output_file.hpp"

namespace raycat::app {
namespace {

namespace fs = std::filesystem;

struct Study {
  const char* name;
  nlohmann::ordered_json (*make)(const StudySettings&, ReportPage&);
  std::vector<const char*> scenes;
};

// In the order of the paper.
const std::vector<Study>& studies() {
  static const std::vector<Study> all{
      {"fig7", study_fig7, {"fig7"}},
      {"fig8", study_fig8, {"fig8"}},
      {"fig9", study_fig9, {"fig9"}},
      {"fig10", study_fig10, {"fig10"}},
      {"fig12", study_fig12, {"fig9", "fig8", "fig10"}},
      {"fig13", study_fig13, {"fig9"}},
      {"fig15", study_fig15, {"fig9"}},
      {"table1", study_table1, {"fig9", "fig8"}},
      {"table2",
       study_table2,
       {"fig8", "fig9", "fig10", "csg_part", "sphereflake", "mesh_csg", "tiles"}}};
  return all;
}

struct StudyOptions {
  std::vector<const Study*> chosen;
  StudySettings settings;
  std::string name;
  std::string folder;
  std::string scenes;
  std::string size;
  bool json = false;
};

// Those installed beside the program, else those of the source tree that it was built from.
fs::path scenes_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/raycat/scenes";
  return !error && fs::is_directory(installed, error) ? installed : fs::path(RAYCAT_SCENES);
}

// Finds out before the work what would go wrong in the middle of it.
void require_scenes(const StudyOptions& options) {
  for (const Study* study : options.chosen) {
    for (const char* scene : study->scenes) {
      const fs::path file = study_file(options.settings, scene);
      std::error_code ignored;
      if (options.settings.scene.empty() && !fs::is_regular_file(file, ignored)) {
        throw UsageError(
            fmt::format("{}: there is no such scene: --scenes names their folder", file.string()));
      }
    }
  }
}

void require_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error == std::errc::not_a_directory || (!error && !fs::is_directory(folder))) {
    throw UsageError(fmt::format("{}: is not a folder", folder.string()));
  }
  if (error) {
    throw std::runtime_error(
        fmt::format("{}: cannot make the folder: {}", folder.string(), error.message()));
  }
  require_writable(folder / "report.html");
}

void introduce(const StudyOptions& options, ReportPage& page) {
  const StudySettings& settings = options.settings;
  page.paragraph(fmt::format("Made by raycat study {} --size {}x{} --largest {}.", options.name,
                             settings.size.width, settings.size.height, settings.largest));
  page.paragraph(
      "The paper is Diego Nehab and Marcelo Gattass, Ray Path Categorization, SIBGRAPI 2000. It "
      "prints pictures but no scene files: its words and its numbers are beside ours here, its "
      "pictures are not.");
  if (!settings.scene.empty()) {
    page.paragraph(
        fmt::format("All is of {}, which takes the place of the paper's scenes; the paper's "
                    "numbers are of its own.",
                    settings.scene));
  } else if (!options.scenes.empty()) {
    page.paragraph(fmt::format("The scenes are those in {}.", options.scenes));
  } else {
    page.paragraph(
        "The scenes are of the same kind and not copies, those of Figs. 8 and 9 framed until their "
        "share of edge pixels came near the paper's.");
  }
}

void study(StudyOptions& options) {
  StudySettings& settings = options.settings;
  settings.sized = !options.size.empty();
  settings.size = parse_size(settings.sized ? options.size : "512x512");
  settings.scenes = options.scenes.empty() ? scenes_folder() : fs::path(options.scenes);
  settings.folder = options.folder;
  require_scenes(options);
  require_folder(settings.folder);

  ReportPage page("Ray Path Categorization: the paper and raycat");
  introduce(options, page);
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();
  for (const Study* chosen : options.chosen) {
    figures[chosen->name] = chosen->make(settings, page);
  }
  const fs::path report = settings.folder / "report.html";
  {
    const InterruptDelay delay;
    write_file(report, page.html());
  }
  if (options.json) {
    print(dump({{"report", report.string()},
                {"width", settings.size.width},
                {"height", settings.size.height},
                {"figures", figures}}));
  } else if (!settings.quiet) {
    print(report.string());
  }
}

void choose(StudyOptions& options, const std::string& name) {
  std::string names;
  for (const Study& each : studies()) {
    if (name == each.name || name == "all") {
      options.chosen.push_back(&each);
    }
    names += std::string(each.name) + ", ";
  }
  if (options.chosen.empty()) {
    throw CLI::ValidationError("NAME", "'" + name + "' is not one of " + names + "all");
  }
  options.name = name;
}

}  // namespace

void add_study(CLI::App& app) {
  auto options = std::make_shared<StudyOptions>();
  StudySettings& settings = options->settings;
  settings.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  CLI::App* command = app.add_subcommand(
      "study", "Make the paper's figures and tables anew, and a page that shows both");
  command
      ->add_option_function<std::string>(
          "NAME", [options = options.get()](const std::string& name) { choose(*options, name); },
          "fig7, fig8, fig9, fig10, fig12, fig13, fig15, table1, table2 or all")
      ->required();
  command
      ->add_option("-o,--out", options->folder,
                   "Takes the pictures, tables, plots and report.html; made if missing")
      ->type_name("DIR")
      ->required();
  command
      ->add_option(
          "--size", options->size,
          "Of all pictures but Fig. 12's; by default 512x512, and the paper's sizes for Table 2")
      ->type_name("WxH");
  command
      ->add_option("--largest", settings.largest,
                   "Fig. 12 goes from 64x64 by factors of two to at most this; 2048 by default")
      ->type_name("N")
      ->check(CLI::Range(128, 16384));
  command->add_flag("--quick", settings.quick,
                    "Table 2 with few of the options, against coarser references");
  CLI::Option* scenes =
      command
          ->add_option("--scenes", options->scenes,
                       "Folder of fig7.gltf, fig8.gltf, fig9.gltf and fig10.gltf; those that came "
                       "with raycat by default")
          ->type_name("DIR");
  command->add_option("--scene", settings.scene, "Scene file to study in place of all these")
      ->type_name("FILE")
      ->excludes(scenes);
  command->add_option("--threads", settings.threads, "Threads; all by default")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", settings.quiet, "No progress and no warnings on stderr");
  command->add_flag("--json", options->json, "What was counted, on stdout");
  command->callback([options] { study(*options); });
}

}  // namespace raycat::app
