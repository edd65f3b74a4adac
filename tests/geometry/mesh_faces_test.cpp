#include "geometry/mesh_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "geometry/weld.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace raycat {
namespace {

using Faces = std::vector<std::uint32_t>;

Faces faces_of(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
               std::span<const glm::vec3> normals, const FaceRule& rule = {}, int threads = 1) {
  return group_faces(positions, triangles, normals, rule, threads).faces;
}

Faces faces_between(std::span<const glm::dvec3> positions, std::span<const glm::uvec3> triangles,
                    std::span<const glm::uvec2> borders, int threads = 1) {
  return group_faces_between(positions, triangles, borders, threads).faces;
}

std::uint32_t count(const Faces& faces) {
  return faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end()) + 1;
}

// Every triangle with corners of its own, as exporters of flat shading write them.
TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(out.positions.size());
    out.positions.insert(out.positions.end(),
                         {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    out.triangles.emplace_back(n, n + 1, n + 2);
  }
  return out;
}

// For a mesh whose triangles share no corners.
std::vector<glm::vec3> flat_normals(const TriangleMesh& mesh) {
  std::vector<glm::vec3> normals;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3& a = mesh.positions[t.x];
    normals.insert(
        normals.end(), 3,
        glm::vec3(glm::normalize(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a))));
  }
  return normals;
}

double area(const std::vector<glm::dvec3>& points, const Faces& polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += glm::cross(points[polygon[i]], points[polygon[(i + 1) % polygon.size()]]);
  }
  return 0.5 * glm::length(sum);
}

// The directed edges that the triangles use more often than their reverse: the polygon's.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> border(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    uses[std::minmax(a, b)] += static_cast<int>(a < b) - static_cast<int>(b < a);
  };
  for (const glm::uvec3& t : mesh.triangles) {
    add(t.x, t.y);
    add(t.y, t.z);
    add(t.z, t.x);
  }
  std::erase_if(uses, [](const auto& use) { return use.second == 0; });
  return uses;
}

void check_covers(const TriangleMesh& mesh, const Faces& polygon, std::size_t triangles) {
  double sum = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const glm::uvec3& t : mesh.triangles) {
    const double part = area(mesh.positions, {t.x, t.y, t.z});
    sum += part;
    least = std::min(least, part);
  }
  CHECK(mesh.triangles.size() == triangles);
  CHECK(sum == Approx(area(mesh.positions, polygon)));  // so that none overlap
  CHECK(least > 1e-9);
}

TEST_CASE("equal points weld to the first, and -0 equals 0", "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points{{0.0, 1.0, 2.0}, {3.0, 1.0, 2.0}, {-0.0, 1.0, 2.0},
                                       {3.0, 1.0, 2.0}, {0.0, 1.0, 2.1}, {0.0, 1.0, 2.0}};
  CHECK(weld(points) == Faces{0, 1, 0, 1, 4, 0});
  CHECK(weld({}).empty());
}

TEST_CASE("points that are not finite weld to nothing", "[geometry][mesh_faces]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> points{
      {infinity, 0.0, 0.0}, {infinity, 0.0, 0.0}, {nan, 0.0, 0.0}, {nan, 0.0, 0.0}};
  CHECK(weld(points) == Faces{0, 1, 2, 3});
}

TEST_CASE("welding agrees with comparing all pairs", "[geometry][mesh_faces]") {
  CHECK(rc::check("first equal point", [](const std::vector<std::uint8_t>& cells) {
    std::vector<glm::dvec3> points;
    for (const std::uint8_t cell : cells) {
      points.emplace_back(0.1 * (cell & 3), 0.1 * (cell >> 2 & 3), (cell & 128) != 0 ? -0.0 : 0.0);
    }
    const Faces first = weld(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto expected = std::find(points.begin(), points.end(), points[i]) - points.begin();
      RC_ASSERT(first[i] == static_cast<std::uint32_t>(expected));
    }
  }));
}

TEST_CASE("points weld and faces are found alike on any number of threads",
          "[geometry][mesh_faces]") {
  const TriangleMesh mesh = split(test::torus(400, 200, 0.02));  // large enough to be parted
  const Faces first = weld(mesh.positions);
  const Faces faces = faces_of(mesh.positions, mesh.triangles, {});
  CHECK(count(faces) > 100);
  CHECK(count(faces) < mesh.triangles.size() / 2);
  const int threads = GENERATE(2, 3, 8);
  CHECK(weld(mesh.positions, threads) == first);
  CHECK(faces_of(mesh.positions, mesh.triangles, {}, {}, threads) == faces);
  const std::vector<glm::uvec2> borders{{0, 1}, {1, 2}, {300, 301}};
  CHECK(faces_between(mesh.positions, mesh.triangles, borders, threads) ==
        faces_between(mesh.positions, mesh.triangles, borders));
}

TEST_CASE("a cube has six faces however it was exported", "[geometry][mesh_faces]") {
  const TriangleMesh cube = test::box(glm::dvec3(-1.0), glm::dvec3(1.0));
  const Faces expected{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5};
  CHECK(faces_of(cube.positions, cube.triangles, {}) == expected);
  const TriangleMesh soup = split(cube);
  CHECK(faces_of(soup.positions, soup.triangles, {}) == expected);
  CHECK(faces_of(soup.positions, soup.triangles, flat_normals(soup)) == expected);
}

TEST_CASE("a cube with smooth normals is one face", "[geometry][mesh_faces]") {
  const TriangleMesh cube = test::box(glm::dvec3(-1.0), glm::dvec3(1.0));
  const std::vector<glm::vec3> normals(cube.positions.begin(), cube.positions.end());  // any length
  CHECK(count(faces_of(cube.positions, cube.triangles, normals)) == 1);
}

TEST_CASE("a flat-shaded cylinder of 32 sides has three faces", "[geometry][mesh_faces]") {
  const TriangleMesh mesh = split(test::prism(32));
  CHECK(count(faces_of(mesh.positions, mesh.triangles, flat_normals(mesh))) == 3);
}

TEST_CASE("the crease is the angle at which faces part", "[geometry][mesh_faces]") {
  const TriangleMesh mesh = test::prism(12);  // 30 degrees from side to side
  const double degree = std::numbers::pi / 180.0;
  CHECK(count(faces_of(mesh.positions, mesh.triangles, {}, {.crease = 30.01 * degree})) == 3);
  CHECK(count(faces_of(mesh.positions, mesh.triangles, {}, {.crease = 29.99 * degree})) == 14);
  CHECK(count(faces_of(mesh.positions, mesh.triangles, {}, {.crease = 91.0 * degree})) == 1);
  CHECK(count(faces_of(mesh.positions, mesh.triangles, {}, {.crease = 1e-6})) == 14);
}

TEST_CASE("a low-poly ball is one face if its normals are smooth, else facets",
          "[geometry][mesh_faces]") {
  const TriangleMesh mesh = test::ball(3);
  const std::vector<glm::vec3> normals(mesh.positions.begin(), mesh.positions.end());
  CHECK(count(faces_of(mesh.positions, mesh.triangles, normals)) == 1);
  CHECK(count(faces_of(mesh.positions, mesh.triangles, {})) == 18);
}

TEST_CASE("three half-planes of one edge join those that continue each other",
          "[geometry][mesh_faces]") {
  // A floor of two triangles and a wall on it.
  const std::vector<glm::dvec3> points{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}};
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  CHECK(faces_of(points, triangles, {}) == Faces{0, 0, 1});
  SECTION("which does not depend on the order") {
    const std::vector<glm::uvec3> shuffled{{4, 0, 1}, {0, 3, 1}, {2, 0, 1}};
    CHECK(faces_of(points, shuffled, {}) == Faces{0, 1, 1});
  }
}

TEST_CASE("of more than two triangles at an edge, those that run along it one way stay apart",
          "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.5, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  CHECK(faces_of(points, triangles, {}) == Faces{0, 1, 2});
}

TEST_CASE("two triangles that run along an edge the same way are compared with one turned over",
          "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.1, 1.0}};
  CHECK(faces_of(points, std::vector<glm::uvec3>{{0, 1, 2}, {0, 1, 3}}, {}) == Faces{0, 0});
  CHECK(faces_of(points, std::vector<glm::uvec3>{{0, 1, 2}, {0, 1, 4}}, {}) == Faces{0, 1});
}

TEST_CASE("the two sides of a sheet stored twice are one face", "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  CHECK(faces_of(points, std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 1}}, {}) == Faces{0, 0});
}

// A floor of rows, each cut into quadrilaterals of its own, tilted.
TriangleMesh bricks(int rows, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> width(0.1, 0.9);
  TriangleMesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (double x = 0.0; x < 10.0;) {
      const double end = std::min(10.0, x + width(random));
      const auto n = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [u, v] : {std::pair(x, row), {end, row}, {end, row + 1}, {x, row + 1}}) {
        mesh.positions.push_back(glm::dvec3(0.36, 0.48, 0.8) * u +
                                 glm::dvec3(-0.8, 0.6, 0.0) * (1.0 * v));
      }
      mesh.triangles.emplace_back(n, n + 1, n + 2);
      mesh.triangles.emplace_back(n, n + 2, n + 3);
      x = end;
    }
  }
  return mesh;
}

TEST_CASE("a flat floor is one face though its rows are cut differently",
          "[geometry][mesh_faces]") {
  TriangleMesh floor = bricks(7, GENERATE(1U, 2U, 3U));
  const double scale = GENERATE(1e-3, 1.0, 1e4);
  const double away = GENERATE(0.0, 1.0, 100.0);
  floor = test::placed(std::move(floor), scale, scale * away * glm::dvec3(0.6, 0.8, -0.3));
  CHECK(count(faces_of(floor.positions, floor.triangles, {})) == 1);
  for (glm::dvec3& p : floor.positions) {
    p = glm::dvec3(glm::vec3(p));
  }
  CHECK(count(faces_of(floor.positions, floor.triangles, {})) == 1);
}

// A triangle below the x axis from 0 to 2, and two above that meet at (1, beside, 0); these rise
// by `rise`.
std::vector<glm::dvec3> junction(double beside, double rise) {
  return {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, beside, 0.0}, {1.0, 1.0, rise}};
}

TEST_CASE("a vertex inside another's edge parts a face only at an angle or a gap",
          "[geometry][mesh_faces]") {
  const std::vector<glm::uvec3> triangles{{1, 0, 2}, {0, 3, 4}, {3, 1, 4}};
  CHECK(faces_of(junction(0.0, 0.0), triangles, {}) == Faces{0, 0, 0});
  CHECK(faces_of(junction(1e-7, 0.0), triangles, {}) == Faces{0, 0, 0});
  CHECK(faces_of(junction(1e-4, 0.0), triangles, {}) == Faces{0, 1, 1});
  CHECK(faces_of(junction(0.0, 0.5), triangles, {}) == Faces{0, 0, 0});
  CHECK(faces_of(junction(0.0, 0.6), triangles, {}) == Faces{0, 1, 1});
  SECTION("also where a triangle without area fills it") {
    const std::vector<glm::uvec3> filled{{1, 0, 2}, {0, 1, 3}, {0, 3, 4}, {3, 1, 4}};
    CHECK(faces_of(junction(0.0, 0.0), filled, {}) == Faces{0, 0, 0, 0});
    CHECK(count(faces_of(junction(0.0, 0.6), filled, {})) == 2);
  }
  SECTION("or where all are stored twice") {
    const std::vector<glm::uvec3> twice{{1, 0, 2}, {0, 3, 4}, {3, 1, 4},
                                        {0, 1, 2}, {0, 4, 3}, {1, 3, 4}};
    CHECK(faces_of(junction(0.0, 0.0), twice, {}) == Faces{0, 0, 0, 0, 0, 0});
    CHECK(faces_of(junction(0.0, 0.6), twice, {}) == Faces{0, 1, 1, 0, 1, 1});
  }
}

TEST_CASE("normals at a vertex inside an edge are those between the edge's ends",
          "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points = junction(0.0, 5.0);
  const std::vector<glm::uvec3> triangles{{1, 0, 2}, {0, 3, 4}, {3, 1, 4}};
  std::vector<glm::vec3> normals{{-1.0F, 0.0F, 1.0F},
                                 {1.0F, 0.0F, 1.0F},
                                 {0.0F, 0.0F, 1.0F},
                                 {0.0F, 0.0F, 1.0F},
                                 {0.0F, 0.0F, 1.0F}};
  CHECK(faces_of(points, triangles, normals) == Faces{0, 0, 0});
  normals[3] = {0.2F, 0.0F, 1.0F};  // 11 degrees off
  CHECK(faces_of(points, triangles, normals) == Faces{0, 1, 1});
}

TEST_CASE("degenerate triangles take a neighbour's face and join nothing",
          "[geometry][mesh_faces]") {
  TriangleMesh cube = test::box(glm::dvec3(-1.0), glm::dvec3(1.0));
  cube.positions.emplace_back(-1.0, -1.0, 0.0);
  const std::vector<glm::uvec3> without_area{{0, 0, 0}, {0, 4, 4}, {0, 4, 8}, {8, 8, 4}, {7, 7, 7}};
  cube.triangles.insert(cube.triangles.begin(), without_area.begin(), without_area.end());
  const Faces faces = faces_of(cube.positions, cube.triangles, {});
  CHECK(count(faces) == 6);
  CHECK(Faces(faces.begin() + 5, faces.begin() + 5 + 2).front() == faces[6]);
}

TEST_CASE("triangles without any neighbour have faces of their own", "[geometry][mesh_faces]") {
  const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  CHECK(faces_of(points, std::vector<glm::uvec3>{{0, 0, 0}, {1, 1, 1}}, {}) == Faces{0, 1});
  CHECK(faces_of(points, {}, {}).empty());
}

TEST_CASE("normals that are zero or not finite agree with nothing", "[geometry][mesh_faces]") {
  const TriangleMesh cube = test::box(glm::dvec3(-1.0), glm::dvec3(1.0));
  const float bad = GENERATE(0.0F, std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity());
  const std::vector<glm::vec3> normals(8, glm::vec3(bad, 0.0F, 0.0F));
  CHECK(count(faces_of(cube.positions, cube.triangles, normals)) == 6);
}

TEST_CASE("told borders part faces, whatever the angles", "[geometry][mesh_faces]") {
  const TriangleMesh cube = split(test::box(glm::dvec3(-1.0), glm::dvec3(1.0)));
  CHECK(count(faces_between(cube.positions, cube.triangles, {})) == 1);
  // A border between the two triangles of each side, by corners of their own.
  std::vector<glm::uvec2> diagonals;
  for (std::uint32_t i = 0; i < cube.triangles.size(); i += 2) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = cube.triangles[i][k];
      const std::uint32_t b = cube.triangles[i][(k + 1) % 3];
      const glm::uvec3& next = cube.triangles[i + 1];
      const auto has = [&](std::uint32_t corner) {
        return cube.positions[next.x] == cube.positions[corner] ||
               cube.positions[next.y] == cube.positions[corner] ||
               cube.positions[next.z] == cube.positions[corner];
      };
      if (has(a) && has(b)) {
        diagonals.emplace_back(b, a);
      }
    }
  }
  REQUIRE(diagonals.size() == 6);
  std::vector<glm::uvec2> all(diagonals);
  for (const glm::uvec3& t : cube.triangles) {
    all.insert(all.end(), {{t.x, t.y}, {t.y, t.z}, {t.z, t.x}});
  }
  CHECK(count(faces_between(cube.positions, cube.triangles, all)) == 12);
  CHECK(count(faces_between(cube.positions, cube.triangles, diagonals)) < 12);
}

TEST_CASE("a convex polygon is a fan", "[geometry][triangulate]") {
  const TriangleMesh mesh =
      triangulate({{0.0, 0.0, 5.0}, {1.0, 0.0, 5.0}, {2.0, 1.0, 5.0}, {1.0, 2.0, 5.0}},
                  std::vector<Faces>{{0, 1, 2, 3}});
  CHECK(mesh.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.faces == Faces{0, 0});
  CHECK(mesh.face_count == 1);
}

TEST_CASE("triangles cover a polygon that is not convex once", "[geometry][triangulate]") {
  SECTION("an L, clockwise as seen from above") {
    const Faces polygon{5, 4, 3, 2, 1, 0};
    const TriangleMesh mesh = triangulate({{0.0, 0.0, 0.0},
                                           {2.0, 0.0, 0.0},
                                           {2.0, 1.0, 0.0},
                                           {1.0, 1.0, 0.0},
                                           {1.0, 2.0, 0.0},
                                           {0.0, 2.0, 0.0}},
                                          std::vector<Faces>{polygon});
    check_covers(mesh, polygon, 4);
  }
  SECTION("with corners in a row") {
    const Faces polygon{0, 1, 2, 3, 4, 5, 6, 7};
    const TriangleMesh mesh = triangulate({{0.0, 0.0, 0.0},
                                           {0.3, 0.0, 0.0},
                                           {0.6, 0.0, 0.0},
                                           {0.9, 0.0, 0.0},
                                           {0.9, 0.0, 0.9},
                                           {0.6, 0.0, 0.9},
                                           {0.3, 0.0, 0.9},
                                           {0.0, 0.0, 0.9}},
                                          std::vector<Faces>{polygon});
    check_covers(mesh, polygon, 6);
  }
  SECTION("a triangle with a corner in each side") {
    const Faces polygon{0, 1, 2, 3, 4, 5};
    const TriangleMesh mesh = triangulate({{0.0, 0.0, 0.0},
                                           {1.0, 0.0, 1.0},
                                           {2.0, 0.0, 2.0},
                                           {1.0, 1.0, 2.0},
                                           {0.0, 2.0, 2.0},
                                           {0.0, 1.0, 1.0}},
                                          std::vector<Faces>{polygon});
    check_covers(mesh, polygon, 4);
  }
  SECTION("a corner repeated") {
    const Faces polygon{0, 1, 1, 2, 3, 3};
    const TriangleMesh mesh =
        triangulate({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.0, 2.0, 0.0}},
                    std::vector<Faces>{polygon});
    check_covers(mesh, polygon, 2);
  }
  SECTION("a square hole on a bridge") {
    const Faces polygon{0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
    const TriangleMesh mesh = triangulate({{0.0, 0.0, 0.0},
                                           {3.0, 0.0, 0.0},
                                           {3.0, 3.0, 0.0},
                                           {0.0, 3.0, 0.0},
                                           {1.0, 1.0, 0.0},
                                           {2.0, 1.0, 0.0},
                                           {2.0, 2.0, 0.0},
                                           {1.0, 2.0, 0.0}},
                                          std::vector<Faces>{polygon});
    check_covers(mesh, polygon, 8);
  }
}

TEST_CASE("random star-shaped polygons are covered once", "[geometry][triangulate]") {
  CHECK(rc::check("areas add up and only the polygon's edges are left", [] {
    const auto n = *rc::gen::inRange<std::uint32_t>(3, 40);
    std::vector<glm::dvec3> points;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double radius = 0.1 * *rc::gen::inRange(1, 20);
      const double u = 2.0 * std::numbers::pi * i / n;
      points.emplace_back(radius * std::cos(u), 0.3 * radius * std::cos(u), radius * std::sin(u));
    }
    Faces polygon(n);
    std::iota(polygon.begin(), polygon.end(), 0U);
    const TriangleMesh mesh = triangulate(points, std::vector<Faces>{polygon});
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
      sum += area(points, {t.x, t.y, t.z});
    }
    RC_ASSERT(std::abs(sum - area(points, polygon)) < 1e-9);
    RC_ASSERT(mesh.triangles.size() == n - 2);
    RC_ASSERT(border(mesh).size() == n);
  }));
}

TEST_CASE("whatever the polygon, a closed mesh stays closed", "[geometry][triangulate]") {
  CHECK(rc::check("only the polygon's own edges are left over", [] {
    const auto corners = *rc::gen::container<Faces>(12, rc::gen::inRange(0U, 9U));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 9; ++i) {
      points.emplace_back(i % 3, i / 3, 0.5);  // many in a row; the polygon crosses itself
    }
    TriangleMesh mesh = triangulate(points, std::vector<Faces>{corners});
    TriangleMesh outline;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {  // a cone over the polygon
      outline.triangles.emplace_back(corners[i], corners[(i + 1) % corners.size()], 9U);
    }
    RC_ASSERT(border(mesh) == border(outline));
  }));
}

TEST_CASE("facets may share a face", "[geometry][triangulate]") {
  const std::vector<glm::dvec3> points{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const std::vector<Faces> polygons{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const TriangleMesh mesh = triangulate(points, polygons, Faces{0, 2, 2, 2});
  CHECK(mesh.faces == Faces{0, 2, 2, 2});
  CHECK(mesh.face_count == 3);
}

TEST_CASE("a polygon that cannot be one is refused by number", "[geometry][triangulate]") {
  const std::vector<glm::dvec3> points(3, glm::dvec3(0.0));
  CHECK_THROWS_WITH(triangulate(points, std::vector<Faces>{{0, 1, 2}, {0, 1}}),
                    "face 1 needs at least 3 corners, but has 2");
  CHECK_THROWS_WITH(triangulate(points, std::vector<Faces>{{0, 1, 3}}),
                    "face 0 has corner 3, but there are 3 points");
}

}  // namespace
}  // namespace raycat
