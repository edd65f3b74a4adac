#include "modelling/height_map.hpp"

#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/modelling/openscad_oracle.hpp"
#include "tests/support/temporary_folder.hpp"

namespace raycat {
namespace {

using Rows = std::vector<std::vector<double>>;

TEST_CASE("a height map's volume is that of its cells", "[modelling][height_map]") {
  // Each cell is worth its mean: 3 and 4.125, over a base at 0.
  const Rows rows{{1, 2, 3}, {4, 5, 6.5}};
  const TriangleMesh map = height_map(rows, false);
  CHECK(volume(map) == Approx(7.125));
  CHECK(map.face_count == 6);
  CHECK_NOTHROW(ClosedMesh(map));
  CHECK(bounds(map).min == glm::dvec3(0));
  CHECK(bounds(map).max == glm::dvec3(2, 1, 6.5));
  CHECK(bounds(height_map(rows, true)).min == glm::dvec3(-1, -0.5, 0));
  CHECK(height_map({{1, 2, 3}}, false).triangles.empty());
  CHECK(height_map({{1}, {2}}, false).triangles.empty());
  CHECK(height_map({}, false).triangles.empty());
}

TEST_CASE("pixels rise to 100", "[modelling][height_map]") {
  CHECK(pixel_height({255, 255, 255}, false) == Approx(100.0));
  CHECK(pixel_height({255, 0, 0}, false) == Approx(21.26));
  CHECK(pixel_height({255, 255, 255}, true) == Approx(-99.607843));
  CHECK(pixel_height({0, 0, 0}, true) == Approx(0.392157));
}

TEST_CASE("height maps are OpenSCAD's", "[modelling][height_map][openscad]") {
  if (!openscad_is_installed()) {
    return;
  }
  const TemporaryFolder folder;
  for (const Rows& rows : {Rows{{1, 2, 3}, {4, 5, 6.5}}, Rows{{5, 9}, {6, 7}, {5.5, 8}},
                           Rows{{1, 2, 3}, {4, 5}, {7, -8, 9, 10}}, Rows{{0, 0}, {0, 0}}}) {
    std::string text = "# heights\n";
    for (const std::vector<double>& row : rows) {
      text += fmt::format("{}\n", fmt::join(row, " "));
    }
    const std::string file = folder.write("heights.dat", text);
    for (const bool centred : {false, true}) {
      const TriangleMesh reference =
          openscad_mesh(fmt::format("surface(file=\"{}\",center={},invert=false);", file, centred));
      const TriangleMesh mesh = height_map(rows, centred);
      CHECK(volume(mesh) == Approx(volume(reference)));
      CHECK(compare(ClosedMesh(mesh), ClosedMesh(reference)).bad == 0);
    }
  }
}

}  // namespace
}  // namespace raycat
