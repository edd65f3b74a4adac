#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/study/page.hpp"
#include "app/study/plot.hpp"
#include "app/view.hpp"
#include "categories/category_trees.hpp"
#include "raycat/scene_view.hpp"

namespace raycat::app {

/// What a study is asked for.
struct StudySettings {
  std::filesystem::path folder;  ///< takes all its files
  std::filesystem::path scenes;  ///< holds the scenes of the paper's figures
  std::string scene;             ///< a file to study in place of these; empty if none
  ImageSize size;                ///< of all pictures but Fig. 12's
  bool sized = false;            ///< was it asked for? Else Table 2 has sizes of its own
  int largest = 2048;            ///< side of Fig. 12's largest picture
  bool quick = false;            ///< a coarse sweep for Table 2
  int threads = 1;
  bool quiet = false;

  /// Warnings about scenes that have been printed, each once for all studies.
  std::shared_ptr<std::set<std::string>> warned = std::make_shared<std::set<std::string>>();
};

/// The file of the paper's scene `name`, such as fig8, or the one in its place.
std::filesystem::path study_file(const StudySettings& settings, const std::string& name);

/// A scene under study, ready to be traced.
struct StudyScene {
  StudyScene(const StudySettings& settings, const std::string& name, const ImageSize& size);

  std::string label;  ///< fig8.gltf, or the user's file as given
  SceneView view;
  Camera camera;
};

/// Its picture and its categories of full detail.
Rendering trace(const StudySettings& settings, const StudyScene& scene, const ImageSize& size,
                int levels);

/// The categories that are left of `levels` levels of `trees`, of full detail, with or without
/// lights. Traces nothing.
CategoryImage at_detail(const StudyScene& scene, CategoryTrees& trees, int levels, bool lights);

/// The number of the edge pixels in `categories` and in a part of an image.
std::uint64_t edge_pixels(const CategoryImage& categories);
double share(std::uint64_t pixels, const ImageSize& size);

/// As tables have it, in percent: 9.02.
std::string percent(double share);

/// Each writes a file, or plots two, into the folder of `settings`, whole or not at all, and
/// returns its name. `name` comes without the extension.
std::string write_picture(const StudySettings& settings, const std::string& name,
                          const Image& image, const std::string& scene);
std::string write_table(const StudySettings& settings, const std::string& name, const Table& table);
std::string write_plots(const StudySettings& settings, const std::string& name, const Plot& plot);

/// Each makes a figure or table of the paper: its files, its section of the page, and what it
/// counted.
nlohmann::ordered_json study_fig7(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig8(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig9(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig10(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig12(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig15(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_fig13(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_table2(const StudySettings& settings, ReportPage& page);
nlohmann::ordered_json study_table1(const StudySettings& settings, ReportPage& page);

}  // namespace raycat::app
