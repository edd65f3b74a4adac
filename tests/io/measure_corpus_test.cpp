#include <cmath>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "io/load_scene.hpp"
#include "tests/io/scene_text.hpp"
#include "tracer/measure.hpp"

namespace raycat {
namespace {

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) {
    out.push_back(field);
  }
  return out;
}

TEST_CASE("volumes and areas of real .csg files are OpenSCAD's", "[io][openscad][measure]") {
  std::ifstream manifest(corpus() / "csg" / "manifest.csv");
  if (!manifest) {
    WARN("skipped: no corpus");
    return;
  }
  int measured = 0;
  double seconds = 0.0;
  std::string line;
  std::getline(manifest, line);
  REQUIRE(line.starts_with("file,cat,leaves,n_nodes,depth,mods,types,volume,area,"));
  while (std::getline(manifest, line)) {
    const std::vector<std::string> row = fields(line);
    if (row[1] != "core") {
      continue;
    }
    INFO(row[0]);
    const SceneFile file = load_scene(corpus() / "csg" / row[0]);
    const std::clock_t start = std::clock();
    const Measurement total = measure(file.scene, default_measure_rays, 2).total;
    seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const double volume = std::stod(row[7]);
    const double area = std::stod(row[8]);
    WARN(fmt::format("{}: volume off by {:+.4f} %, said to be {:.4f} %; area by {:+.4f} %", row[0],
                     100.0 * (total.volume->value / volume - 1.0),
                     100.0 * total.volume->error / volume,
                     100.0 * (total.area->value / area - 1.0)));
    CHECK(std::abs(total.volume->value / volume - 1.0) < 2e-3);
    CHECK(std::abs(total.area->value / area - 1.0) < 2e-3);
    // The STL's own numbers have six or seven digits.
    CHECK(std::abs(total.volume->value - volume) < 3.5 * total.volume->error + 1e-6 * volume);
    ++measured;
  }
  WARN(fmt::format("{} files measured in {:.2f} CPU seconds", measured, seconds));
  CHECK(measured == 18);
}

}  // namespace
}  // namespace raycat
