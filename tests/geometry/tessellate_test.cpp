#include "geometry/tessellate.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "geometry/placed_shape.hpp"

namespace raycat {
namespace {

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
  }
  return sum / 6.0;
}

// How far the points of the triangles are from the surface at most, along the triangles' normals,
// which is no less than the distance; and whether the surface there is of the same face.
struct Fit {
  double farthest = 0.0;
  int other_face = 0;
};

Fit fit(const Shape& shape, const TriangleMesh& mesh) {
  Fit out;
  Crossings crossings;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::dvec3& a = mesh.positions[mesh.triangles[i].x];
    const glm::dvec3& b = mesh.positions[mesh.triangles[i].y];
    const glm::dvec3& c = mesh.positions[mesh.triangles[i].z];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    if (!(glm::length(normal) > 1e-12)) {
      continue;
    }
    for (const glm::dvec3& weight : {glm::dvec3(0.34, 0.33, 0.33), glm::dvec3(0.498, 0.498, 0.004),
                                     glm::dvec3(0.004, 0.498, 0.498)}) {
      crossings.clear();
      cross(shape,
            {.origin = weight.x * a + weight.y * b + weight.z * c,
             .direction = glm::normalize(normal)},
            crossings);
      double nearest = std::numeric_limits<double>::infinity();
      std::uint32_t face = 0;
      for (const Crossing& crossing : crossings) {
        if (!crossing.entering && std::abs(crossing.t) < nearest) {
          nearest = std::abs(crossing.t);
          face = crossing.face;
        }
      }
      out.farthest = std::max(out.farthest, nearest);
      out.other_face += face == mesh.faces[i] ? 0 : 1;
    }
  }
  return out;
}

TEST_CASE("tessellated shapes are closed, near the surface, and of its faces",
          "[geometry][tessellate]") {
  const std::vector<Shape> shapes{Sphere{.radius = 2.0},
                                  Box{.size = {1, 2, 3}},
                                  Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0},
                                  Cylinder{.height = 2.0, .radius_top = 0.5, .radius_bottom = 1.5},
                                  Cylinder{.height = 2.0, .radius_top = 0.0, .radius_bottom = 1.5},
                                  Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 0.0},
                                  Capsule{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0},
                                  Capsule{.height = 2.0, .radius_top = 0.3, .radius_bottom = 1.0},
                                  Capsule{.height = 2.0, .radius_top = 1.0, .radius_bottom = 0.0},
                                  Capsule{.height = 2.0, .radius_top = 0.0, .radius_bottom = 1.0},
                                  Capsule{.height = 0.5, .radius_top = 0.3, .radius_bottom = 1.0},
                                  Torus{.radius = 2.0, .tube = 0.5},
                                  Torus{.radius = 1.0, .tube = 1.5}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const double error : {0.1, 0.01, 0.0005}) {
      INFO("shape " << i << ", chord error " << error);
      const TriangleMesh mesh = tessellate(shapes[i], error);
      CHECK_NOTHROW(ClosedMesh(mesh));
      CHECK(mesh.face_count == face_count(shapes[i]));
      const Fit found = fit(shapes[i], mesh);
      CHECK(found.farthest <= error * 1.0001 + 1e-12);
      CHECK(found.other_face == 0);
    }
  }
}

TEST_CASE("tessellations come near the volume", "[geometry][tessellate]") {
  constexpr double pi = 3.141592653589793;
  CHECK(volume(tessellate(Sphere{.radius = 2.0}, 1e-4)) == Approx(32.0 / 3.0 * pi).epsilon(3e-4));
  CHECK(volume(tessellate(Torus{.radius = 2.0, .tube = 0.5}, 1e-4)) ==
        Approx(pi * pi).epsilon(1e-3));
  CHECK(volume(tessellate(Box{.size = {1, 2, 3}}, 1e-4)) == Approx(6.0));
}

TEST_CASE("what takes too many triangles is refused", "[geometry][tessellate]") {
  CHECK_THROWS_WITH(tessellate(Sphere{}, 1e-9),
                    Catch::Contains("a curved surface takes at most 4194304 triangles"));
  CHECK_THROWS_WITH(tessellate(Torus{}, 0.0), Catch::Contains("takes inf"));
  CHECK_THROWS_WITH(tessellate(HalfSpace{}, 0.1), Catch::Contains("a half-space has no end"));
}

}  // namespace
}  // namespace raycat
