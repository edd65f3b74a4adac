#include "geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "geometry/line_view.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace raycat {
namespace {

using test::ball;
using test::box;
using test::flipped;
using test::placed;
using test::together;
using test::torus;

Crossings crossings(const ClosedMesh& mesh, const Ray& ray) {
  Crossings out;
  mesh.cross(ray, out);
  return out;
}

// What every line must keep to; empty if it does.
std::string fault(const ClosedMesh& mesh, const Ray& ray) {
  const Crossings found = crossings(mesh, ray);
  if (found.size() % 2 != 0) {
    return fmt::format("{} crossings", found.size());
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double slope = glm::dot(found[i].normal, ray.direction);
    if (found[i].entering != (i % 2 == 0) || (i > 0 && !(found[i - 1].t < found[i].t)) ||
        (found[i].entering ? slope >= 0.0 : slope <= 0.0)) {
      return fmt::format("crossing {} at {} after {}", i, found[i].t, i > 0 ? found[i - 1].t : 0.0);
    }
  }
  return {};
}

class Random {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }
  glm::dvec3 point(double reach) {
    return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)};
  }

 private:
  std::mt19937 engine_{7};
};

glm::dvec3 vertex(const TriangleMesh& mesh, std::size_t triangle, int corner) {
  return mesh.positions[mesh.triangles[triangle][corner]];
}

// Rays at what is hardest: vertices, edges, along edges, along the axes, in a triangle's plane.
Ray adversarial_ray(const TriangleMesh& mesh, Random& random) {
  const std::size_t i = random.below(mesh.triangles.size());
  const glm::dvec3 a = vertex(mesh, i, 0);
  const glm::dvec3 b = vertex(mesh, i, 1);
  const glm::dvec3 c = vertex(mesh, i, 2);
  const double size = glm::length(bounds(mesh).half_size());
  const glm::dvec3 origin = bounds(mesh).center() + random.point(3.0 * size);
  const int axis = static_cast<int>(random.below(3));
  glm::dvec3 along_axis(0.0);
  along_axis[axis] = random.below(2) == 0 ? 1.0 : -1.0;
  switch (random.below(8)) {
    case 0:
      return {origin, a - origin};
    case 1:
      return {origin, 0.5 * (a + b) - origin};
    case 2:
      return {a, b - a};
    case 3:
      return {a - (b - a), b - a};
    case 4:
      return {a, along_axis};
    case 5:
      return {0.5 * (a + b), along_axis};
    case 6:
      return {a, 0.3 * b + 0.7 * c - a};
    default:
      return {b + 1e6 * size * along_axis, -along_axis};
  }
}

TEST_CASE("a line through a cube enters and leaves it once, at its faces", "[geometry][mesh]") {
  const ClosedMesh cube(box(glm::dvec3(-1.0), glm::dvec3(1.0)));
  const Crossings found =
      crossings(cube, {.origin = {0.3, 0.2, 10.0}, .direction = {0.0, 0.0, -2.0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == 4.5);
  CHECK(found[0].face == 5);
  CHECK(found[0].entering);
  CHECK(glm::normalize(found[0].normal) == glm::dvec3(0.0, 0.0, 1.0));
  CHECK(found[1].t == 5.5);
  CHECK(found[1].face == 4);
  CHECK_FALSE(found[1].entering);
  CHECK(glm::normalize(found[1].normal) == glm::dvec3(0.0, 0.0, -1.0));
}

TEST_CASE("a lattice of lines along the axes passes each cube of a wall exactly once",
          "[geometry][mesh]") {
  // Lines meet vertices, edges and diagonals, and run in faces. Neighbours share each face, so
  // that a line in it must be in just one of them.
  TriangleMesh left = box({-1.0, -1.0, -1.0}, {0.0, 1.0, 1.0});
  TriangleMesh right = box({0.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  const ClosedMesh whole(box(glm::dvec3(-1.0), glm::dvec3(1.0)));
  const ClosedMesh a(std::move(left));
  const ClosedMesh b(std::move(right));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      for (int i = -5; i <= 5; ++i) {
        for (int j = -5; j <= 5; ++j) {
          Ray ray{.origin = glm::dvec3(0.0), .direction = glm::dvec3(0.0)};
          ray.origin[axis] = -7.0 * sign;
          ray.origin[(axis + 1) % 3] = 0.25 * i;
          ray.origin[(axis + 2) % 3] = 0.25 * j;
          ray.direction[axis] = sign;
          CAPTURE(axis, sign, i, j);
          CHECK(fault(whole, ray).empty());
          const Crossings found = crossings(whole, ray);
          const std::size_t parts = crossings(a, ray).size() + crossings(b, ray).size();
          CHECK(parts == (axis == 0 ? 2 : 1) * found.size());
          if (std::max(std::abs(i), std::abs(j)) != 4) {
            CHECK(found.size() == (std::max(std::abs(i), std::abs(j)) < 4 ? 2 : 0));
          }
        }
      }
    }
  }
}

// Triangles halved at random at the middle of a side, each without a look at its neighbours.
TriangleMesh halved_at_random(TriangleMesh mesh, int times, std::uint32_t seed) {
  std::mt19937 engine(seed);
  for (int i = 0; i < times; ++i) {
    const std::size_t which =
        std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(engine);
    const glm::uvec3 t = mesh.triangles[which];
    const int side = std::uniform_int_distribution<int>(0, 2)(engine);
    const std::uint32_t a = t[side];
    const std::uint32_t b = t[(side + 1) % 3];
    const std::uint32_t c = t[(side + 2) % 3];
    const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    mesh.triangles[which] = {a, middle, c};
    mesh.triangles.emplace_back(middle, b, c);
    mesh.faces.push_back(mesh.faces[which]);
  }
  return mesh;
}

TEST_CASE("a mesh is closed though vertices lie on edges, exactly", "[geometry][mesh]") {
  const TriangleMesh box = test::box({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5});
  const ClosedMesh whole(box);
  const int halvings = GENERATE(1, 5, 60, 300);
  const std::uint32_t seed = GENERATE(1U, 2U);
  const TriangleMesh mesh = halved_at_random(box, halvings, seed);
  const ClosedMesh cut(mesh);
  CHECK(test::volume(cut.mesh()) == 8.0);
  CHECK(cut.mesh().triangles.size() > mesh.triangles.size());
  for (const glm::uvec3& t : cut.mesh().triangles) {
    const auto& p = cut.mesh().positions;
    CHECK(glm::length(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x])) > 0.0);
  }
  Random random;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = adversarial_ray(cut.mesh(), random);
    CAPTURE(halvings, seed, i);
    CHECK(fault(cut, ray).empty());
    if (i % 2 == 0) {  // and one that meets nothing in particular
      const Ray any{.origin = random.point(4.0), .direction = random.point(1.0)};
      const Crossings expected = crossings(whole, any);
      const Crossings found = crossings(cut, any);
      REQUIRE(found.size() == expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        CHECK(found[k].t == Approx(expected[k].t).margin(1e-12));
        CHECK(found[k].face == expected[k].face);
      }
    }
  }
}

TEST_CASE("a vertex that is a bit beside an edge leaves it open", "[geometry][mesh]") {
  TriangleMesh mesh = halved_at_random(test::box({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5}), 1, 1);
  CHECK_NOTHROW(ClosedMesh(mesh));
  glm::dvec3& middle = mesh.positions.back();
  middle += glm::dvec3(std::nextafter(1.0, 2.0) - 1.0);
  CHECK_THROWS_WITH(ClosedMesh(mesh), Catch::Contains("3 edges are open"));
}

TEST_CASE("a hole stays one though its border has vertices on edges", "[geometry][mesh]") {
  TriangleMesh mesh = halved_at_random(test::box(glm::dvec3(-1.0), glm::dvec3(1.0)), 20, 3);
  mesh.triangles.pop_back();
  mesh.faces.pop_back();
  CHECK_THROWS_WITH(ClosedMesh(mesh), Catch::Contains("open"));
}

TEST_CASE("every line enters and leaves in turn, at any scale and place", "[geometry][mesh]") {
  const double scale = GENERATE(1e-6, 1.0, 1e6);
  const double offset = GENERATE(0.0, 3.0, 1e4);  // in sizes of the mesh
  std::vector<TriangleMesh> meshes{box(glm::dvec3(-1.0), glm::dvec3(1.0)), torus(24, 12),
                                   torus(40, 20, 0.15), ball(2), ball(16)};
  Random random;
  for (TriangleMesh& shape : meshes) {
    const ClosedMesh mesh(placed(shape, scale, offset * scale * glm::dvec3(1.0, -0.7, 0.3)));
    std::string first_fault;
    for (int i = 0; i < 2000 && first_fault.empty(); ++i) {
      first_fault = fault(mesh, adversarial_ray(mesh.mesh(), random));
      const glm::dvec3 origin = mesh.bounds().center() + random.point(2.0 * scale);
      first_fault += fault(mesh, {.origin = origin, .direction = random.point(1.0)});
    }
    CAPTURE(scale, offset, mesh.mesh().triangles.size(), first_fault);
    CHECK(first_fault.empty());
  }
}

void leave_out_thin_parts(std::vector<double>& ts, double nearest) {
  std::vector<double> kept;
  for (const double t : ts) {
    if (!kept.empty() && t - kept.back() < nearest) {
      kept.pop_back();
    } else {
      kept.push_back(t);
    }
  }
  ts = kept;
}

TEST_CASE("Embree leaves out no triangle that the line passes", "[geometry][mesh]") {
  const double scale = GENERATE(1e-6, 1.0, 1e6);
  const ClosedMesh mesh(placed(torus(40, 20, 0.2), scale, glm::dvec3(0.4 * scale)));
  Random random;
  for (int i = 0; i < 2000; ++i) {
    // An origin in the box is the view's origin, so that the areas and signs are the same bits.
    Ray ray = i % 2 == 0
                  ? Ray{glm::dvec3(0.4 * scale) + random.point(0.3 * scale), random.point(1.0)}
                  : adversarial_ray(mesh.mesh(), random);
    const Bounds& box = mesh.bounds();
    ray.origin = glm::clamp(ray.origin, box.min, box.max);
    const LineView view(ray.origin, ray.direction);
    std::vector<std::pair<double, int>> passages;
    for (const glm::uvec3& t : mesh.mesh().triangles) {
      const glm::dvec3 a = view(mesh.mesh().positions[t.x]);
      const glm::dvec3 b = view(mesh.mesh().positions[t.y]);
      const glm::dvec3 c = view(mesh.mesh().positions[t.z]);
      const int side = side_of_line(a, b);
      if (side != 0 && side_of_line(b, c) == side && side_of_line(c, a) == side) {
        const double wa = area_at_line(b, c);
        const double wb = area_at_line(c, a);
        const double wc = area_at_line(a, b);
        passages.emplace_back(view.parameter((wa * a.z + wb * b.z + wc * c.z) / (wa + wb + wc)),
                              -side);
      }
    }
    std::sort(passages.begin(), passages.end());
    std::vector<double> expected;
    int winding = 0;
    for (const auto& [t, turn] : passages) {
      const bool was_inside = winding > 0;
      winding += turn;
      if (was_inside != (winding > 0)) {
        expected.push_back(t);
      }
    }
    CHECK(winding == 0);
    std::vector<double> found;
    for (const Crossing& crossing : crossings(mesh, ray)) {
      found.push_back(crossing.t);
    }
    // What rounding may or may not merge.
    const double nearest = 1e-12 * scale / glm::length(ray.direction);
    leave_out_thin_parts(found, nearest);
    leave_out_thin_parts(expected, nearest);
    INFO(i);
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(std::abs(found[k] - expected[k]) <= nearest);
    }
  }
}

TEST_CASE("between entering and leaving, solid angles say inside", "[geometry][mesh]") {
  CHECK(rc::check("winding numbers agree with crossings", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const ClosedMesh mesh(torus(*rc::gen::inRange(3U, 12U), *rc::gen::inRange(3U, 9U), 0.2, seed));
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> at(-1.5, 1.5);
    const Ray ray{.origin = {at(engine), at(engine), at(engine)},
                  .direction = {at(engine), at(engine), at(engine)}};
    const Crossings found = crossings(mesh, ray);
    double before = -10.0;
    for (std::size_t i = 0; i <= found.size(); ++i) {
      const double after = i < found.size() ? found[i].t : 10.0;
      if (after - before > 1e-6) {
        const double winding = test::winding_number(mesh.mesh(), ray.at(0.5 * (before + after)));
        RC_ASSERT((std::round(winding) > 0.0) == (i % 2 == 1));
      }
      before = after;
    }
  }));
}

TEST_CASE("the thickness along parallel lines adds up to the volume", "[geometry][mesh]") {
  const ClosedMesh mesh(torus(60, 30));
  const Bounds box = mesh.bounds();
  constexpr int n = 150;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const glm::dvec3 size = box.max - box.min;
    double sum = 0.0;
    for (int i = 0; i < n * n; ++i) {
      Ray ray{.origin = box.min, .direction = glm::dvec3(0.0)};
      ray.direction[axis] = 1.0;
      ray.origin[u] += size[u] * (i % n + 0.5) / n;
      ray.origin[v] += size[v] * (i / n + 0.5) / n;
      for (const Crossing& crossing : crossings(mesh, ray)) {
        sum += crossing.entering ? -crossing.t : crossing.t;
      }
    }
    CHECK(sum * size[u] * size[v] / (n * n) == Approx(test::volume(mesh.mesh())).epsilon(2e-3));
  }
}

TEST_CASE("a shell turned inside out is a cavity", "[geometry][mesh]") {
  const ClosedMesh mesh(together(box(glm::dvec3(-2.0), glm::dvec3(2.0)),
                                 flipped(box(glm::dvec3(-1.0), glm::dvec3(1.0)))));
  const Crossings found = crossings(mesh, {.origin = glm::dvec3(0.1, 0.2, 0.0)});
  REQUIRE(found.size() == 4);
  CHECK(found[0].t == -2.0);
  CHECK(found[1].t == -1.0);
  CHECK(found[1].face == 6 + 5);
  CHECK(glm::normalize(found[1].normal) == glm::dvec3(0.0, 0.0, -1.0));
  CHECK(found[2].t == 1.0);
  CHECK(found[3].t == 2.0);
}

TEST_CASE("overlapping shells are united", "[geometry][mesh]") {
  SECTION("through each other") {
    const ClosedMesh mesh(
        together(box(glm::dvec3(0.0), glm::dvec3(2.0)), box(glm::dvec3(1.0), glm::dvec3(3.0))));
    const Crossings found = crossings(mesh, {{1.5, 1.25, 0.0}, {0.0, 0.0, 1.0}});
    REQUIRE(found.size() == 2);
    CHECK(found[0].t == 0.0);
    CHECK(found[1].t == 3.0);
  }
  SECTION("face to face") {
    const ClosedMesh mesh(
        together(box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), box({0.2, 0.2, 1.0}, {0.9, 0.9, 2.0})));
    const Crossings found = crossings(mesh, {{0.5, 0.3, -5.0}, {0.01, 0.02, 1.0}});
    REQUIRE(found.size() == 2);
    CHECK(found[0].t == Approx(5.0));
    CHECK(found[1].t == Approx(7.0));
  }
  SECTION("twice the same") {
    const TriangleMesh cube = box(glm::dvec3(0.0), glm::dvec3(1.0));
    CHECK(crossings(ClosedMesh(together(cube, cube)), {glm::dvec3(0.3), {0.3, 0.5, 0.1}}).size() ==
          2);
  }
}

TEST_CASE("a plate thinner than its triangles' rounding in single precision is kept",
          "[geometry][mesh]") {
  const ClosedMesh plate(box({-1.0, -1.0, 0.0}, {1.0, 1.0, 1e-12}));
  const Crossings found = crossings(plate, {{0.5, 0.3, 5.0}, {0.0, 0.0, -1.0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].t < found[1].t);
}

TEST_CASE("a far origin costs no precision across the line", "[geometry][mesh]") {
  const ClosedMesh cube(box(glm::dvec3(0.0), glm::dvec3(1e-3)));
  const double distance = GENERATE(1.0, 1e5, 1e9);
  const Ray inside{{0.999999999e-3, 0.5e-3, distance}, {0.0, 0.0, -1.0}};
  const Ray outside{{1.000000001e-3, 0.5e-3, distance}, {0.0, 0.0, -1.0}};
  const Crossings found = crossings(cube, inside);
  REQUIRE(found.size() == 2);
  CHECK(found[1].t - found[0].t == Approx(1e-3).margin(1e-15 * distance));
  CHECK(crossings(cube, outside).empty());
}

TEST_CASE("a mesh too far to have a thickness is not crossed", "[geometry][mesh]") {
  const ClosedMesh cube(box(glm::dvec3(0.0), glm::dvec3(1e-3)));
  CHECK(crossings(cube, {{0.5e-3, 0.5e-3, 1e16}, {0.0, 0.0, -1.0}}).empty());
}

TEST_CASE("lines are crossed on many threads as on one", "[geometry][mesh]") {
  const ClosedMesh mesh(ball(20));
  const auto all = [&] {
    Crossings out;
    Random random;
    for (int i = 0; i < 500; ++i) {
      mesh.cross({random.point(1.0), random.point(1.0)}, out);
    }
    return out;
  };
  Crossings first;
  Crossings second;
  {
    const std::jthread a([&] { first = all(); });
    const std::jthread b([&] { second = all(); });
  }
  CHECK_FALSE(first.empty());
  CHECK(first == second);
  CHECK(first == all());
}

TEST_CASE("a mesh that encloses no volume is refused by name", "[geometry][mesh]") {
  using Catch::Message;
  const TriangleMesh cube = box(glm::dvec3(0.0), glm::dvec3(2.0));
  SECTION("a face is missing") {
    TriangleMesh open = box(glm::dvec3(0.0), glm::dvec3(1.0));
    open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
    open.faces.erase(open.faces.begin(), open.faces.begin() + 2);
    CHECK_THROWS_MATCHES(
        ClosedMesh(open), std::invalid_argument,
        Message("edge (0, 0, 1) to (0, 0, 0) is open; 4 edges are open or inconsistently "
                "oriented"));
  }
  SECTION("a triangle is turned over") {
    TriangleMesh turned = cube;
    std::swap(turned.triangles[0].x, turned.triangles[0].y);
    CHECK_THROWS_WITH(ClosedMesh(turned), Catch::Contains("is inconsistently oriented; 3 edges"));
  }
  SECTION("inside out") {
    CHECK_THROWS_MATCHES(ClosedMesh(flipped(cube)), std::invalid_argument,
                         Message("the mesh is inside out: its volume is -8"));
  }
  SECTION("an index is out of range") {
    TriangleMesh wrong = cube;
    wrong.triangles[3].y = 8;
    CHECK_THROWS_MATCHES(ClosedMesh(wrong), std::invalid_argument,
                         Message("triangle 3 has vertex 8, but there are 8"));
  }
  SECTION("a coordinate is not finite") {
    TriangleMesh wrong = cube;
    wrong.positions[1].y = std::numeric_limits<double>::infinity();
    CHECK_THROWS_MATCHES(ClosedMesh(wrong), std::invalid_argument,
                         Message("vertex 1 has a coordinate that is not finite: (2, inf, 0)"));
  }
  SECTION("no triangles, or a sheet with two sides") {
    CHECK_THROWS_WITH(ClosedMesh(TriangleMesh{}), "the mesh has no volume");
    TriangleMesh sheet{.positions = {{0.1, 0.2, 0.3}, {1.3, 0.1, 0.7}, {0.2, 1.9, 0.4}},
                       .triangles = {{0, 1, 2}, {0, 2, 1}},
                       .faces = {0, 0},
                       .face_count = 1};
    CHECK_THROWS_WITH(ClosedMesh(sheet), "the mesh has no volume");
  }
}

TEST_CASE("equal positions are one vertex, and triangles without area open nothing",
          "[geometry][mesh]") {
  TriangleMesh soup;
  const TriangleMesh cube = box(glm::dvec3(0.0), glm::dvec3(1.0));
  for (const glm::uvec3& t : cube.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.positions.size());
    for (int k = 0; k < 3; ++k) {
      glm::dvec3 p = cube.positions[t[k]];
      p.x = p.x == 0.0 && k == 1 ? -0.0 : p.x;
      soup.positions.push_back(p);
    }
    soup.triangles.emplace_back(n, n + 1, n + 2);
    soup.triangles.emplace_back(n, n + 1, n + 1);
  }
  soup.faces.assign(soup.triangles.size(), 0);
  soup.face_count = 1;
  const ClosedMesh mesh(soup);
  CHECK(mesh.mesh().positions.size() == 8);
  CHECK(mesh.mesh().triangles.size() == 12);
  CHECK(crossings(mesh, {glm::dvec3(0.4, 0.3, 0.2), {1.0, 0.3, 0.2}}).size() == 2);
}

TEST_CASE("a triangle with its corners in a row joins edges that meet halfway",
          "[geometry][mesh]") {
  // The middle of an edge of the cube is a vertex for one of its two sides only.
  TriangleMesh cube = box(glm::dvec3(-1.0), glm::dvec3(1.0));
  cube.positions.emplace_back(-1.0, -1.0, 0.1);  // on the edge from corner 0 to corner 4
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> faces;
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    glm::uvec3 t = cube.triangles[i];
    const bool has_edge =
        (t.x == 0 && t.y == 4) || (t.y == 0 && t.z == 4) || (t.z == 0 && t.x == 4);
    if (!has_edge) {
      triangles.push_back(t);
      faces.push_back(cube.faces[i]);
      continue;
    }
    const std::uint32_t apex = t.x + t.y + t.z - 4;
    triangles.insert(triangles.end(), {{0U, 8U, apex}, {8U, 4U, apex}, {0U, 4U, 8U}});
    faces.insert(faces.end(), {cube.faces[i], cube.faces[i], cube.faces[i]});
  }
  // The sliver's edge from 0 to 4 takes the place of the side's.
  cube.triangles = triangles;
  cube.faces = faces;
  const ClosedMesh mesh(cube);
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 origin = random.point(4.0);
    const glm::dvec3 target(-1.0, -1.0, random.uniform(-1.0, 1.0));
    CHECK(fault(mesh, {origin, target - origin}).empty());
  }
}

}  // namespace
}  // namespace raycat
