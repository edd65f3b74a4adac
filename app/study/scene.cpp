#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/interrupt.hpp"
#include "app/progress_bar.hpp"
#include "app/report.hpp"
#include "app/study/study.hpp"
#include "categories/recode.hpp"
#include "edges/edge_map.hpp"
#include "io/files/output_file.hpp"
#include "io/images/image_file.hpp"
#include "io/load_scene.hpp"

namespace raycat::app {
namespace {

namespace fs = std::filesystem;

SceneFile load(const StudySettings& settings, const std::string& name) {
  SceneFile file = load_scene(study_file(settings, name));
  for (const std::string& warning : file.warnings) {
    if (!settings.quiet && settings.warned->insert(warning).second) {
      warn({warning});
    }
  }
  return file;
}

}  // namespace

fs::path study_file(const StudySettings& settings, const std::string& name) {
  return settings.scene.empty() ? settings.scenes / (name + ".gltf") : fs::path(settings.scene);
}

StudyScene::StudyScene(const StudySettings& settings, const std::string& name,
                       const ImageSize& size)
    : label(settings.scene.empty() ? name + ".gltf" : settings.scene),
      view(load(settings, name)),
      camera(view.camera(size.width, size.height)) {}

Rendering trace(const StudySettings& settings, const StudyScene& scene, const ImageSize& size,
                int levels) {
  ProgressBar bar(fmt::format("{} {}x{}", scene.label, size.width, size.height), settings.quiet);
  return render(scene.view.accel(), scene.camera,
                {.width = size.width,
                 .height = size.height,
                 .levels = levels,
                 .threads = settings.threads,
                 .mark_textures = false,
                 .progress = bar.callback()});
}

CategoryImage at_detail(const StudyScene& scene, CategoryTrees& trees, int levels, bool lights) {
  const Detail detail{.levels = levels, .lights = lights};
  return recode(trees, detail, scene.view.scene().surfaces,
                make_encoder(Method::heap, extent(scene.view.scene(), detail, levels)));
}

std::uint64_t edge_pixels(const CategoryImage& categories) {
  return detect_edges(categories).count();
}

double share(std::uint64_t pixels, const ImageSize& size) {
  return static_cast<double>(pixels) / (static_cast<double>(size.width) * size.height);
}

std::string percent(double share) { return fmt::format("{:.2f}", 100.0 * share); }

std::string write_picture(const StudySettings& settings, const std::string& name,
                          const Image& image, const std::string& scene) {
  std::string file = name + ".png";
  const std::string figure = name.substr(0, name.find('-'));
  const InterruptDelay delay;
  write_image(settings.folder / file, image,
              {.command = fmt::format("raycat study {} --size {}x{}", figure, settings.size.width,
                                      settings.size.height),
               .scene = scene});
  return file;
}

std::string write_table(const StudySettings& settings, const std::string& name,
                        const Table& table) {
  std::string file = name + ".csv";
  const InterruptDelay delay;
  write_file(settings.folder / file, csv(table));
  return file;
}

std::string write_plots(const StudySettings& settings, const std::string& name, const Plot& plot) {
  const InterruptDelay delay;
  for (const char* extension : {".svg", ".png"}) {
    write_plot(settings.folder / (name + extension), plot);
  }
  return name;
}

}  // namespace raycat::app
