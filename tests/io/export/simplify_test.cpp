// Triangles made fewer: the surface stays where it is, and so do its faces.

#include "io/export/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/io/scene_text.hpp"

namespace raycat {
namespace {

// A ball with a bore and a bite.
constexpr const char* model = R"csg(
difference() {
  sphere($fn = 0, $fa = 6, $fs = 0.2, r = 10);
  cylinder($fn = 48, $fa = 12, $fs = 2, h = 40, r1 = 4, r2 = 4, center = true);
  multmatrix([[1, 0, 0, 8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
    sphere($fn = 30, $fa = 12, $fs = 2, r = 5);
  }
}
)csg";

// Of `p` from a triangle: within it, or from one of its sides.
double distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  double nearest = std::numeric_limits<double>::infinity();
  bool within = true;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const glm::dvec3 side = to - from;
    within = within && glm::dot(glm::cross(side, p - from), normal) >= 0.0;
    const double s = glm::clamp(glm::dot(p - from, side) / glm::dot(side, side), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, from + s * side));
  }
  return within ? std::abs(glm::dot(p - a, normal)) / glm::length(normal) : nearest;
}

double distance(const glm::dvec3& p, const TriangleMesh& mesh) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::uvec3& t : mesh.triangles) {
    nearest = std::min(nearest,
                       distance(p, mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]));
  }
  return nearest;
}

using Corner = std::array<double, 3>;

Corner corner(const TriangleMesh& mesh, std::uint32_t i) {
  return {mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z};
}

// The edges between triangles of two faces, by their ends. Every edge must be run along once each
// way.
std::set<std::pair<Corner, Corner>> borders(const TriangleMesh& mesh) {
  std::map<std::pair<Corner, Corner>, std::uint32_t> face_of;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto [at, is_new] = face_of.try_emplace(
          {corner(mesh, mesh.triangles[i][k]), corner(mesh, mesh.triangles[i][(k + 1) % 3])},
          mesh.faces[i]);
      CHECK(is_new);
    }
  }
  std::set<std::pair<Corner, Corner>> out;
  for (const auto& [edge, face] : face_of) {
    const auto other = face_of.find({edge.second, edge.first});
    REQUIRE(other != face_of.end());
    if (face < other->second) {
      out.insert(edge);
    }
  }
  return out;
}

TEST_CASE("a simplified solid is as near as asked for, with its faces' borders as they were",
          "[io][simplify]") {
  const double error = GENERATE(1e-3, 1e-2, 3e-2);
  const SceneFile file = load_text("a.csg", model);
  const std::vector<ObjectMesh> exact = object_meshes(file.scene, 1e-3);
  std::vector<ObjectMesh> fewer = exact;
  CHECK(simplify(file.scene.surfaces, fewer, error).empty());
  const TriangleMesh before = welded_mesh(exact.at(0));
  const TriangleMesh after = welded_mesh(fewer.at(0));
  CAPTURE(error, before.triangles.size(), after.triangles.size());
  CHECK(after.triangles.size() < before.triangles.size());
  const Bounds box = bounds(before);
  const double most = error * glm::length(box.half_size());
  for (const glm::dvec3& position : before.positions) {
    CHECK(distance(position, after) <= most * (1.0 + 1e-9));
  }
  for (const glm::uvec3& t : after.triangles) {
    const glm::dvec3 middle =
        (after.positions[t.x] + after.positions[t.y] + after.positions[t.z]) / 3.0;
    CHECK(distance(middle, before) <= 2.0 * most);
  }
  CHECK(borders(after) == borders(before));
  CHECK(std::set(after.faces.begin(), after.faces.end()) ==
        std::set(before.faces.begin(), before.faces.end()));
  CHECK(signed_volume(after) == Approx(signed_volume(before)).epsilon(10.0 * error));
}

TEST_CASE("what all lies on borders stays as it is", "[io][simplify]") {
  const SceneFile file = load_text("a.csg", "cube(size = [1, 2, 3], center = false);");
  std::vector<ObjectMesh> objects = object_meshes(file.scene, 1e-3);
  const TriangleMesh before = welded_mesh(objects.at(0));
  CHECK(simplify(file.scene.surfaces, objects, 0.5).empty());
  CHECK(welded_mesh(objects.at(0)).triangles == before.triangles);
}

TEST_CASE("a mesh that is not manifold is left alone, and said to be", "[io][simplify]") {
  const SceneFile file = load_text(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 2 1 5\n");
  std::vector<ObjectMesh> objects = object_meshes(file.scene, 1e-3);
  CHECK(simplify(file.scene.surfaces, objects, 0.1) ==
        std::vector<std::string>{"a: is not simplified: its triangles do not make up a manifold, "
                                 "or an image tells its faces, or a face has seams"});
  CHECK(welded_mesh(objects.at(0)).triangles.size() == 3);
}

}  // namespace
}  // namespace raycat
