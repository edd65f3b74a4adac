#include "geometry/crease.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "geometry/mesh_faces.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace raycat {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::uint32_t face_count(const TriangleMesh& mesh, double crease) {
  return 1 + std::ranges::max(
                 group_faces(mesh.positions, mesh.triangles, {}, {.crease = crease}).faces);
}

double rounded(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  return std::round(value * unit) / unit;
}

TriangleMesh turned(TriangleMesh mesh, const glm::dmat3& rotation) {
  for (glm::dvec3& p : mesh.positions) {
    p = rotation * p;
  }
  return mesh;
}

TriangleMesh in_floats(TriangleMesh mesh) {
  for (glm::dvec3& p : mesh.positions) {
    p = glm::dvec3(glm::vec3(p));
  }
  return mesh;
}

TEST_CASE("all edges of a prism at exactly the crease part its sides", "[geometry][crease]") {
  const std::uint32_t sides = GENERATE(6U, 8U, 9U, 10U, 12U, 18U, 24U, 36U);
  const double crease = 2.0 * std::numbers::pi / sides;
  const TriangleMesh prism = test::prism(sides);
  std::mt19937 random(sides);
  std::normal_distribution<double> part;
  for (int i = 0; i < 50; ++i) {
    const glm::dquat rotation =
        glm::normalize(glm::dquat(part(random), part(random), part(random), part(random)));
    const TriangleMesh any_way = turned(prism, glm::mat3_cast(rotation));
    for (const double scale : {1e-3, 1.0, 7e4}) {
      for (const double away : {0.0, 10.0, 300.0}) {
        CAPTURE(sides, i, scale, away);
        const glm::dvec3 offset = scale * away * glm::dvec3(0.6, -0.64, 0.48);
        const TriangleMesh there = test::placed(any_way, scale, offset);
        CHECK(face_count(there, crease) == sides + 2);
        CHECK(face_count(in_floats(there), crease) == sides + 2);
      }
    }
  }
}

TEST_CASE("a crease a little wider joins all sides of a prism", "[geometry][crease]") {
  const std::uint32_t sides = GENERATE(6U, 12U, 36U);
  const double crease = 2.0 * std::numbers::pi / sides + 0.01 * degree;
  const TriangleMesh prism =
      turned(test::prism(sides), glm::mat3_cast(glm::normalize(glm::dquat(0.3, 0.2, 0.9, 0.1))));
  CHECK(face_count(prism, crease) == 3);
  CHECK(face_count(in_floats(prism), crease) == 3);
}

TEST_CASE("five digits are enough for the sides of a prism at the crease to be alike",
          "[geometry][crease]") {
  TriangleMesh prism = test::prism(12);
  for (glm::dvec3& p : prism.positions) {
    p = {rounded(p.x, 5), rounded(p.y, 5), rounded(p.z, 5)};
  }
  CHECK(face_count(prism, 30.0 * degree) == 14);
}

TEST_CASE("rounding turns a plane by no more than its tilt", "[geometry][crease]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  double greatest = 0.0;
  for (int i = 0; i < 20000; ++i) {
    std::array<glm::dvec3, 3> corners;
    const glm::dvec3 away = 50.0 * glm::dvec3(at(random), at(random), at(random));
    for (glm::dvec3& corner : corners) {
      corner = away + glm::dvec3(at(random), at(random), at(random));
    }
    const auto normal = [](const std::array<glm::dvec3, 3>& t) {
      return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    };
    const glm::dvec3 before = normal(corners);
    const double tilt = rounding_tilt(corners);
    for (glm::dvec3& corner : corners) {
      corner = glm::dvec3(glm::vec3(corner));
    }
    if (tilt < 1e-3) {  // else terms of second order count
      greatest = std::max(greatest, glm::length(normal(corners) - before) / tilt);
    }
  }
  CHECK(greatest <= 1.0);
  CHECK(greatest > 0.1);  // and it is of that order
}

TEST_CASE("a triangle without area may lie any way", "[geometry][crease]") {
  CHECK(rounding_tilt({glm::dvec3(1.0), glm::dvec3(2.0), glm::dvec3(3.0)}) ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("of a crease of nothing no angle is under it", "[geometry][crease]") {
  const Crease crease(0.0);
  const auto none = [] { return 0.0; };
  CHECK_FALSE(crease.joins({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, none));
  CHECK(Crease(1e-9).joins({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, none));
}

TEST_CASE("noise takes no more than a 32nd of the crease", "[geometry][crease]") {
  const auto at = [](double degrees) {
    return glm::dvec3(std::cos(degrees * degree), std::sin(degrees * degree), 0.0);
  };
  const auto noise = [] { return std::numeric_limits<double>::infinity(); };
  const Crease crease(32.0 * degree);
  CHECK(crease.joins(at(0.0), at(30.999), noise));
  CHECK_FALSE(crease.joins(at(0.0), at(31.001), noise));
  CHECK(crease.joins(at(0.0), at(31.001), [] { return 0.0; }));
  CHECK_FALSE(crease.joins(at(0.0), at(32.0), [] { return 0.0; }));
}

}  // namespace
}  // namespace raycat
