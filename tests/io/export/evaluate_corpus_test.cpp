#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "io/load_scene.hpp"
#include "modelling/evaluate.hpp"
#include "tests/io/scene_text.hpp"
#include "tests/support/sanitized.hpp"

namespace raycat {
namespace {

struct Known {
  std::string file;
  double volume = 0.0;
};

// The files of one kind that the manifest lists, with their exact volumes.
std::vector<Known> listed(const std::string& kind) {
  std::vector<Known> out;
  std::ifstream manifest(corpus() / "csg" / "manifest.csv");
  for (std::string line; std::getline(manifest, line);) {
    std::istringstream fields(line);
    std::vector<std::string> field;
    for (std::string one; std::getline(fields, one, ',');) {
      field.push_back(one);
    }
    if (field.at(1) == kind) {
      out.push_back({.file = field[0], .volume = std::strtod(field.at(7).c_str(), nullptr)});
    }
  }
  return out;
}

TEST_CASE("evaluated .csg files are closed and have the volumes of OpenSCAD's",
          "[io][openscad][evaluate]") {
  const std::vector<Known> files = listed("core");
  if (files.empty()) {
    WARN("skipped: no corpus");
    return;
  }
  for (const Known& known : files) {
    INFO(known.file);
    if (sanitized && known.file == "example024.csg") {
      WARN("left out of a sanitizer's build for its time: " << known.file);
      continue;
    }
    const SceneFile scene = load_scene(corpus() / "csg" / known.file);
    double sum = 0.0;
    std::size_t triangles = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (const SolidObject& object : scene.scene.solids) {
      const EvaluatedMesh evaluated = evaluate(object.solid.tree());
      CHECK_NOTHROW(ClosedMesh(evaluated.mesh));
      sum += signed_volume(evaluated.mesh);
      triangles += evaluated.mesh.triangles.size();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    WARN(fmt::format("{}: {} triangles, {:.2f} s, volume off by {:.1e}", known.file, triangles,
                     seconds.count(), sum / known.volume - 1.0));
    CHECK(sum == Approx(known.volume).epsilon(1e-4));
  }
  CHECK(files.size() >= 18);
}

}  // namespace
}  // namespace raycat
