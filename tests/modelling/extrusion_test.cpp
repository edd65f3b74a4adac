#include "modelling/extrusion.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "modelling/smooth_runs.hpp"
#include "tests/modelling/openscad_oracle.hpp"
#include "tests/modelling/sample_contours.hpp"

namespace raycat {
namespace {

TEST_CASE("a square extruded is a block of six faces", "[modelling][extrusion]") {
  const TriangleMesh block = linear_extrusion({{square(1, 2, 3)}}, {.height = 4, .z0 = -2});
  CHECK(block.triangles.size() == 12);
  CHECK(block.face_count == 6);
  CHECK(volume(block) == Approx(36.0));
  const Bounds box = bounds(block);
  CHECK(box.min == glm::dvec3(1, 2, -2));
  CHECK(box.max == glm::dvec3(4, 5, 2));
  CHECK(linear_extrusion({}, {}).triangles.empty());
}

TEST_CASE("the wall of a smooth contour is one face", "[modelling][extrusion]") {
  CHECK(linear_extrusion({{circle(1, 30)}}, {}).face_count == 3);
  CHECK(linear_extrusion({{circle(1, 13)}}, {}).face_count == 3);
  CHECK(linear_extrusion({{circle(1, 12)}}, {}).face_count == 14);  // 30 degrees are a crease
  Contour typed = circle(10, 12);
  for (glm::dvec2& corner : typed) {
    corner = glm::dvec2(std::round(1e4 * corner.x), std::round(1e4 * corner.y)) / 1e4;
  }
  CHECK(linear_extrusion({{typed}}, {}).face_count == 14);
  // A half disc, whose contour begins in the middle of the arc.
  Contour half;
  for (int i = 0; i <= 24; ++i) {
    half.push_back(unit_vector(180.0 * i / 24));
  }
  std::ranges::rotate(half, half.begin() + 7);
  CHECK(linear_extrusion({{half}}, {}).face_count == 4);
  const std::vector<std::uint32_t> runs = smooth_runs(half);
  CHECK(std::set(runs.begin(), runs.end()).size() == 2);
}

TEST_CASE("scaled tops have the volume of a prismatoid", "[modelling][extrusion]") {
  const Polygons base{{square(-1, -1, 2)}};
  CHECK(volume(linear_extrusion(base, {.height = 6, .scale = {0, 0}})) == Approx(8.0));
  CHECK(volume(linear_extrusion(base, {.height = 6, .scale = {0, 1}})) == Approx(12.0));
  CHECK(volume(linear_extrusion(base, {.height = 6, .scale = {2, 2}})) == Approx(56.0));
  CHECK(linear_extrusion(base, {.height = 6, .scale = {0, 0}}).face_count == 5);
  CHECK(linear_extrusion(base, {.height = 6, .scale = {0, 1}}).face_count == 5);
}

TEST_CASE("a twist keeps the area of every slice in the limit", "[modelling][extrusion]") {
  const Polygons base = even_odd(std::vector<Contour>{square(1, 1, 4), square(2, 2, 1)});
  const TriangleMesh twisted = linear_extrusion(base, {.height = 10, .twist = 300, .slices = 1000});
  CHECK(volume(twisted) == Approx(150.0).epsilon(1e-3));
  // Clockwise seen from above: the corner (5, 1) of the bottom goes to (1, -5).
  const TriangleMesh quarter =
      linear_extrusion({{square(0, 0, 1)}}, {.height = 1, .twist = 90, .slices = 9});
  CHECK(bounds(quarter).min.y == -1.0);
}

TEST_CASE("slices follow the longest helix", "[modelling][extrusion]") {
  const Polygons base{{square(-1, -1, 2)}};
  const LinearExtrusion turn{.height = 10, .twist = 360};
  CHECK(default_slices(base, {.height = 10}, {}) == 1);
  const double helix = std::hypot(10.0, 2.0 * std::numbers::pi * std::numbers::sqrt2);
  CHECK(default_slices(base, turn, {}) == std::ceil(helix / 2.0));
  CHECK(default_slices(base, turn, {.angle = 60}) == 6);
  CHECK(default_slices(base, turn, {.number = 17}) == 17);
  CHECK(default_slices(base, turn, {.number = 1}) == 3);  // at least one every 120 degrees
  CHECK_THROWS_WITH(default_slices(base, {.twist = 1e9}, {.number = 100}),
                    Catch::Contains("at most 1000000 slices"));
}

TEST_CASE("a square swept around is a tube", "[modelling][extrusion]") {
  const Polygons profile{{square(2, 0, 1)}};
  const double facet = std::sin(2.0 * std::numbers::pi / 24.0);
  const TriangleMesh tube = rotate_extrusion(profile, {.fragments = 24});
  CHECK(volume(tube) == Approx(24 * 0.5 * facet * (9.0 - 4.0)));
  CHECK(tube.face_count == 4);
  const TriangleMesh quarter = rotate_extrusion(profile, {.angle = 90, .fragments = 6});
  CHECK(volume(quarter) == Approx(volume(tube) / 4.0));
  CHECK(quarter.face_count == 6);
  CHECK(bounds(quarter).min.x == 0.0);
  CHECK(bounds(rotate_extrusion(profile, {.angle = -90, .fragments = 6})).min.y == -3.0);
  CHECK(bounds(tube).min.x == -3.0);
  CHECK(rotate_extrusion(profile, {.angle = 0.0}).triangles.empty());
}

TEST_CASE("a profile at the axis closes there", "[modelling][extrusion]") {
  const Polygons triangle{{{{0, 0}, {2, 0}, {0, 3}}}};
  const TriangleMesh cone = rotate_extrusion(triangle, {.fragments = 36});
  CHECK(cone.face_count == 2);
  CHECK(cone.triangles.size() == 72);
  CHECK(volume(cone) == Approx(36 * 0.5 * 4.0 * std::sin(2.0 * std::numbers::pi / 36.0)));
  CHECK_NOTHROW(ClosedMesh(rotate_extrusion(triangle, {.angle = 77, .fragments = 5})));
  CHECK_THROWS_WITH(rotate_extrusion({{square(-1, 0, 3)}}, {}),
                    "a rotate extrusion needs a profile on one side of the y axis, but x goes from "
                    "-1 to 2");
}

TEST_CASE("every extrusion is a closed mesh", "[modelling][extrusion]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    // Whole coordinates for contours that touch; turned, for corners that are rounded.
    const Polygons whole =
        even_odd(std::vector<Contour>{random_contour(random, 4 + i % 12, i % 2 == 0 ? 4.0 : 50.0)});
    const glm::dvec2 x = unit_vector(360.0 * part(random));
    const Polygons turned = transformed(whole, {x, {-x.y, x.x}, {200, part(random)}});
    const Polygons merged = combined(
        Operation::set_union, std::array{turned, transformed(turned, {{1, 0}, {0, 1}, 0.25 * x})});
    for (const Polygons& polygons : {whole, turned, merged}) {
      if (polygons.contours.empty()) {
        continue;
      }
      LinearExtrusion linear{.height = 3.0};
      if (i % 3 > 0) {
        linear.twist = 300.0 * (part(random) - 0.5);
        linear.slices = 20 + static_cast<std::uint32_t>(i % 7);
        linear.scale = {i % 5 == 0 ? 0.0 : part(random), i % 10 == 0 ? 0.0 : 2.0 * part(random)};
      }
      const TriangleMesh mesh = linear_extrusion(polygons, linear);
      CHECK_NOTHROW(ClosedMesh(mesh));
      if (i % 3 == 0) {
        CHECK(volume(mesh) == Approx(3.0 * area(polygons)));
      }
    }
    for (const Polygons& profile : {turned, merged}) {
      if (!profile.contours.empty()) {
        const double angle = i % 2 == 0 ? 360.0 : 700.0 * (part(random) - 0.5);
        CHECK_NOTHROW(ClosedMesh(rotate_extrusion(profile, {.angle = angle, .fragments = 5})));
      }
    }
  }
}

}  // namespace
}  // namespace raycat
