#include "geometry/coincident_twins.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "geometry/mesh_faces.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace raycat {
namespace {

using Numbers = std::vector<std::uint32_t>;

const std::vector<glm::dvec3> corners{
    {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.0}};

// Every triangle twice, with corners of its own; the second time turned round.
TriangleMesh stored_twice(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const TriangleMesh& side : {mesh, test::flipped(mesh)}) {
    for (const glm::uvec3& t : side.triangles) {
      for (int k = 0; k < 3; ++k) {
        out.positions.push_back(side.positions[t[k]]);
      }
      const auto n = static_cast<std::uint32_t>(out.positions.size());
      out.triangles.emplace_back(n - 3, n - 2, n - 1);
    }
  }
  return out;
}

TEST_CASE("a mesh without copies has no twins", "[geometry][twins]") {
  const TriangleMesh ball = test::ball(5);
  CHECK(coincident_twins(ball.positions, ball.triangles).empty());
  CHECK(coincident_twins({}, {}).empty());
}

TEST_CASE("a triangle and the same one turned round are twins", "[geometry][twins]") {
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {1, 3, 2}, {2, 1, 0}};
  CHECK(coincident_twins(corners, triangles) == Numbers{2, no_twin, 0});
}

TEST_CASE("a copy wound as the first is a copy, but no twin", "[geometry][twins]") {
  const std::vector<glm::uvec3> triangles{{0, 1, 2}, {1, 2, 0}, {1, 3, 2}};
  CHECK(coincident_twins(corners, triangles) == Numbers{no_twin, 0, no_twin});
}

TEST_CASE("of many copies the first is kept, with the first turned round as its twin",
          "[geometry][twins]") {
  const std::vector<glm::uvec3> triangles{{1, 2, 0}, {0, 1, 2}, {0, 2, 1}, {2, 0, 1}, {1, 0, 2}};
  CHECK(coincident_twins(corners, triangles) == Numbers{2, 0, 0, 0, 0});
}

TEST_CASE("triangles with two corners at one point have no copies", "[geometry][twins]") {
  const std::vector<glm::uvec3> triangles{{0, 1, 1}, {0, 1, 1}, {1, 1, 0}, {2, 2, 2}, {2, 2, 2}};
  CHECK(coincident_twins(corners, triangles).empty());
}

TEST_CASE("twins are found by where their corners are", "[geometry][twins]") {
  const std::vector<glm::dvec3> points{{0.0, 0.0, 0.0},  {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                       {0.0, -0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}};
  CHECK(coincident_twins(points, std::vector<glm::uvec3>{{0, 1, 2}, {3, 4, 5}}) == Numbers{1, 0});
}

// The definition, by looking at all triangles for each.
Numbers by_definition(const std::vector<glm::uvec3>& triangles) {
  const auto turned_first = [](const glm::uvec3& t) {  // with the lowest corner first
    const int low = t.x < t.y && t.x < t.z ? 0 : (t.y < t.z ? 1 : 2);
    return std::array{t[low], t[(low + 1) % 3], t[(low + 2) % 3]};
  };
  Numbers out(triangles.size(), no_twin);
  bool any = false;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto [a, b, c] = turned_first(triangles[i]);
    if (a == b || b == c || c == a) {
      continue;
    }
    for (std::uint32_t j = 0; j < triangles.size() && out[i] == no_twin; ++j) {
      const auto other = turned_first(triangles[j]);
      const bool turned = other == std::array{a, c, b};
      if (j < i ? turned || other == std::array{a, b, c} : turned) {
        out[i] = j;
        any = true;
      }
    }
  }
  return any ? out : Numbers{};
}

TEST_CASE("twins are those of the definition", "[geometry][twins]") {
  CHECK(rc::check("on few points", [] {
    const auto numbers = *rc::gen::container<Numbers>(rc::gen::inRange(0U, 6U));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 6; ++i) {
      points.emplace_back(i, i * i, 0.0);
    }
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
      triangles.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    RC_ASSERT(coincident_twins(points, triangles) == by_definition(triangles));
    RC_ASSERT(group_faces(points, triangles, {}).twins == by_definition(triangles));
    RC_ASSERT(group_faces_between(points, triangles, {}).twins == by_definition(triangles));
  }));
}

TEST_CASE("twins and faces are the same on any number of threads", "[geometry][twins]") {
  const TriangleMesh mesh = stored_twice(test::torus(150, 150, 0.02));
  const int threads = GENERATE(2, 5);
  const Numbers twins = coincident_twins(mesh.positions, mesh.triangles);
  REQUIRE(twins.size() == mesh.triangles.size());
  CHECK(coincident_twins(mesh.positions, mesh.triangles, threads) == twins);
  const MeshFaces one = group_faces(mesh.positions, mesh.triangles, {});
  const MeshFaces many = group_faces(mesh.positions, mesh.triangles, {}, {}, threads);
  CHECK(many.faces == one.faces);
  CHECK(one.twins == twins);
  CHECK(many.twins == twins);
}

TEST_CASE("a mesh stored twice, in any order, has the faces of one stored once",
          "[geometry][twins]") {
  const TriangleMesh once = GENERATE(test::box(glm::dvec3(-1.0), glm::dvec3(1.0)),
                                     test::torus(40, 20, 0.05), test::ball(3), test::ball(12));
  const Numbers expected = group_faces(once.positions, once.triangles, {}).faces;
  TriangleMesh twice = stored_twice(once);
  std::mt19937 random(5);
  const std::size_t half = once.triangles.size();
  std::vector<std::size_t> order(2 * half);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  std::vector<glm::uvec3> triangles;
  for (const std::size_t i : order) {
    triangles.push_back(twice.triangles[i]);
  }
  const Numbers faces = group_faces(twice.positions, triangles, {}).faces;
  std::map<std::uint32_t, std::uint32_t> found;  // by the face that it should be
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [place, is_new] = found.emplace(expected[order[i] % half], faces[i]);
    REQUIRE(place->second == faces[i]);
  }
  CHECK(std::ranges::max(faces) == std::ranges::max(expected));
}

TEST_CASE("smooth normals join what is stored twice as what is stored once", "[geometry][twins]") {
  const TriangleMesh ball = test::ball(3);  // whose facets meet at more than 30 degrees
  TriangleMesh twice = stored_twice(ball);
  std::vector<glm::vec3> normals;
  for (std::size_t i = 0; i < twice.positions.size(); ++i) {
    const bool back = i >= twice.positions.size() / 2;
    normals.emplace_back(back ? -twice.positions[i] : twice.positions[i]);
  }
  // Front and back take turns in being first.
  std::vector<glm::uvec3> triangles;
  const std::size_t half = ball.triangles.size();
  for (std::size_t i = 0; i < half; ++i) {
    const std::size_t first = i % 2 == 0 ? i : half + i;
    triangles.push_back(twice.triangles[first]);
    triangles.push_back(twice.triangles[(first + half) % (2 * half)]);
  }
  const Numbers faces = group_faces(twice.positions, triangles, normals).faces;
  CHECK(std::ranges::max(faces) == 0);
}

TEST_CASE("faces told by a file are joined where they are of copies", "[geometry][twins]") {
  const Numbers twins{2, no_twin, 0, no_twin};
  CHECK(with_copies_joined({3, 3, 0, 1}, twins) == Numbers{0, 0, 0, 1});
  CHECK(with_copies_joined({3, 1, 0, 1}, twins) == Numbers{0, 1, 0, 1});
  CHECK(with_copies_joined({3, 1, 0, 1}, {}) == Numbers{3, 1, 0, 1});
}

}  // namespace
}  // namespace raycat
