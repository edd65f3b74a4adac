#include "geometry/surface_piece.hpp"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/tessellate.hpp"

namespace raycat {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

std::vector<Shape> shapes() {
  return {Sphere{.radius = 1.2},
          Box{.size = {1, 2, 3}},
          Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0},
          Cylinder{.height = 2.0, .radius_top = 0.4, .radius_bottom = 1.0},
          Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 0.0},
          Capsule{.height = 2.0, .radius_top = 0.5, .radius_bottom = 1.0},
          Capsule{.height = 2.0, .radius_top = 0.7, .radius_bottom = 0.7},
          Capsule{.height = 0.5, .radius_top = 0.2, .radius_bottom = 1.0},
          HalfSpace{},
          Torus{.radius = 1.0, .tube = 0.3},
          Torus{.radius = 0.5, .tube = 0.8},
          std::make_shared<const ClosedMesh>(tessellate(Torus{.radius = 1.0, .tube = 0.4}, 0.05))};
}

bool set(const PlacedShape& shape, std::uint32_t piece, const glm::dvec3& from, SurfacePiece& out) {
  const auto* mesh = std::get_if<MeshShape>(&shape.shape());
  return mesh != nullptr ? set_triangle((*mesh)->mesh(), piece, shape.transform(), from, out)
                         : set_piece(shape, piece, from, 3.0, out);
}

TEST_CASE("a crossing lies on the piece that it names, where the line passes through that",
          "[geometry][surface]") {
  Random random(3);
  for (const Shape& shape : shapes()) {
    CAPTURE(shape.index());
    std::size_t crossed = 0;
    std::vector<bool> seen(piece_count(shape));
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 axis(uniform(random, -1, 1), uniform(random, -1, 1), 1.0);
      const glm::dvec3 at(uniform(random, -4, 4), 3.0, -2.0);
      const double mirror = random() % 2 == 0 ? 1.0 : -1.0;
      const PlacedShape placed(
          shape, Affine(glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), at),
                                               uniform(random, 0, 6), glm::normalize(axis)),
                                   glm::dvec3(mirror * uniform(random, 0.5, 2), 1.0, 0.7))));
      const glm::dvec3 to =
          at + glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      const glm::dvec3 from(uniform(random, -9, 9), uniform(random, -9, 9), -8.0);
      const Ray ray{.origin = from, .direction = to - from};
      Crossings crossings;
      placed.cross(ray, crossings);
      for (const Crossing& crossing : crossings) {
        SurfacePiece piece;
        REQUIRE(crossing.piece < seen.size());
        REQUIRE(set(placed, crossing.piece, at, piece));
        seen[crossing.piece] = true;
        const glm::dvec3 point = ray.at(crossing.t) - at;
        const Ray line{.origin = ray.origin - at, .direction = ray.direction};
        const double t = piece.planar ? piece.plane.passage(line)
                                      : piece.curved.passage(line, crossing.t, crossing.entering);
        const double cosine = std::abs(glm::dot(glm::normalize(ray.direction), crossing.normal));
        REQUIRE((piece.planar ? piece.plane.distance(point) : piece.curved.distance(point)) < 1e-9);
        if (piece.planar) {
          REQUIRE(glm::dot(piece.plane.normal, crossing.normal) > 1.0 - 1e-9);
        }
        if (cosine > 1e-3) {
          REQUIRE(std::abs(t - crossing.t) < 1e-9);
          ++crossed;
        }
      }
    }
    CHECK(crossed > 500);
    if (!std::holds_alternative<MeshShape>(shape)) {
      for (std::uint32_t piece = 0; piece < seen.size(); ++piece) {
        // One ball of a capsule may hold the other.
        const bool inner =
            std::holds_alternative<Capsule>(shape) && std::get<Capsule>(shape).height < 0.8;
        CHECK((seen[piece] || inner));
      }
    }
  }
}

TEST_CASE("samples lie on their piece, and its width and area are the ones of a box and a disc",
          "[geometry][surface]") {
  for (const Shape& shape : shapes()) {
    const PlacedShape placed(
        shape,
        Affine(glm::scale(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3))),
                          glm::dvec3(-1.5, 1.0, 0.7))));
    for (std::uint32_t i = 0; i < piece_count(shape); ++i) {
      SurfacePiece piece;
      if (set(placed, i, {0.1, 0.2, 0.3}, piece)) {
        CHECK(piece.samples.size() >= 3);
        for (const glm::dvec3& sample : piece.samples) {
          REQUIRE((piece.planar ? piece.plane.distance(sample) : piece.curved.distance(sample)) <
                  1e-12);
        }
      }
    }
  }
  SurfacePiece face;
  REQUIRE(set_piece(PlacedShape(Box{.size = {1, 2, 3}}), 0, {}, 1.0, face));
  CHECK(face.extent == Approx(6.0));
  REQUIRE(set_piece(PlacedShape(Cylinder{.height = 1, .radius_top = 2, .radius_bottom = 2}), 1, {},
                    1.0, face));
  CHECK(face.extent == Approx(4.0 * M_PI));
}

}  // namespace
}  // namespace raycat
