#include "geometry/coincident_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/tessellate.hpp"

namespace raycat {
namespace {

using Place = CoincidentSurfaces::Place;
using Random = std::mt19937;

constexpr std::uint32_t none = CoincidentSurfaces::none;
constexpr double tolerance = 1e-6;
constexpr Bounds everywhere{.min = glm::dvec3(-std::numeric_limits<double>::infinity()),
                            .max = glm::dvec3(std::numeric_limits<double>::infinity())};
constexpr Bounds whole{.min = glm::dvec3(-5.0), .max = glm::dvec3(5.0)};

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

glm::dmat4 moved(const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); }

glm::dmat4 turned(double angle) {
  return glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1, 2, 3)));
}

// Motions, and maps that do not make a gap along y of 1 tolerance more or less than that.
std::vector<glm::dmat4> maps() {
  return {glm::dmat4(1.0), turned(0.7), moved({0.3, -0.2, 0.1}) * turned(2.0),
          turned(1.1) * glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0)),
          turned(0.4) * glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 1.0, 0.5))};
}

CoincidentSurfaces found(const std::vector<PlacedShape>& parts, const Bounds& where = everywhere) {
  CoincidentSurfaces surfaces(whole, tolerance);
  for (const PlacedShape& part : parts) {
    surfaces.add(part, where);
  }
  surfaces.find();
  return surfaces;
}

PlacedShape placed(Shape shape, const glm::dmat4& map) {
  return PlacedShape(std::move(shape), Affine(map));
}

TEST_CASE("the tolerance is a part of the half diagonal, but no less than what rounding does",
          "[geometry][coincident]") {
  CHECK(coincidence_tolerance({.min{-1, -2, -2}, .max{1, 2, 2}}) == Approx(3e-7));
  const double far = coincidence_tolerance({.min{5e9, 0, 0}, .max{5e9 + 10.0, 10, 10}});
  const double ulp = std::nextafter(5e9, 6e9) - 5e9;
  CHECK(far > 4.0 * ulp);
  CHECK(far < 32.0 * ulp);
  CHECK(coincidence_tolerance({}) == 1e-7);
}

TEST_CASE("a box on another shares the face between them and the planes of its sides",
          "[geometry][coincident]") {
  for (const glm::dmat4& map : maps()) {
    for (const double gap : {0.0, 0.9 * tolerance, -0.9 * tolerance}) {
      const CoincidentSurfaces surfaces =
          found({placed(Box{.size = {2, 1, 2}}, map),
                 placed(Box{.size = {2, 3, 1}}, map * moved({0, 2.0 + gap, 0}))});
      CHECK(surfaces.any());
      CHECK(surfaces.surfaces() == 3);  // x = -1 and 1, and between them
      CHECK(surfaces.place(0, 0).surface != none);
      CHECK(surfaces.place(0, 0).surface == surfaces.place(1, 0).surface);
      CHECK(surfaces.place(0, 0).reversed == surfaces.place(1, 0).reversed);
      CHECK(surfaces.place(0, 1).surface == surfaces.place(1, 1).surface);
      CHECK(surfaces.place(0, 1).surface != surfaces.place(0, 0).surface);
      CHECK(surfaces.place(0, 3).surface == surfaces.place(1, 2).surface);
      CHECK(surfaces.place(0, 3).reversed != surfaces.place(1, 2).reversed);
      CHECK_FALSE(surfaces.place(0, 3).reversed);  // of the larger piece
      CHECK(surfaces.farthest() == Approx(std::abs(gap)).margin(1e-12));
      for (const std::uint32_t lone : {2U, 4U, 5U}) {
        CHECK(surfaces.place(0, lone) == Place{});
      }
    }
    const CoincidentSurfaces apart =
        found({placed(Box{.size = {2, 1, 2}}, map),
               placed(Box{.size = {1, 3, 1}}, map * moved({0, 2.0 + 1.1 * tolerance, 0}))});
    CHECK_FALSE(apart.any());
    CHECK(apart.surfaces() == 0);
    CHECK(apart.place(0, 3) == Place{});
  }
}

TEST_CASE("planes that cross within the tolerance are apart where a piece is",
          "[geometry][coincident]") {
  // Hinged along an edge: 2 across, so that the far edge is 2 * angle away.
  const auto tilted = [](double angle) {
    const glm::dmat4 hinge = glm::rotate(moved({-1, 0.5, 0}), angle, glm::dvec3(0, 0, 1));
    return found({placed(Box{.size = {4, 1, 4}}, glm::dmat4(1.0)),
                  placed(Box{.size = {2, 1, 2}}, hinge * moved({1, 0.5, 0}))});
  };
  CHECK(tilted(0.45 * tolerance).any());
  CHECK_FALSE(tilted(0.55 * tolerance).any());
}

// Shapes that have one curved piece, and the same but for a gap.
std::vector<std::pair<Shape, Shape>> curved_twins(double gap) {
  const double slope = std::hypot(1.0, 0.25);  // a radius grows by this for a gap across the cone
  return {
      {Sphere{.radius = 1.0}, Sphere{.radius = 1.0 + gap}},
      {Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0},
       Cylinder{.height = 1.0, .radius_top = 1.0 + gap, .radius_bottom = 1.0 + gap}},
      {Cylinder{.height = 2.0, .radius_top = 0.5, .radius_bottom = 1.0},
       Cylinder{
           .height = 1.0, .radius_top = 0.625 + gap * slope, .radius_bottom = 0.875 + gap * slope}},
      {Cylinder{.height = 2.0, .radius_top = 1.0, .radius_bottom = 1.0},
       Capsule{.height = 3.0, .radius_top = 1.0 + gap, .radius_bottom = 1.0 + gap}},
      {Torus{.radius = 1.0, .tube = 0.25}, Torus{.radius = 1.0, .tube = 0.25 + gap}},
      {Torus{.radius = 1.0, .tube = 1.25}, Torus{.radius = 1.0 + gap, .tube = 1.25}}};
}

TEST_CASE("curved pieces share a surface if they are nowhere apart", "[geometry][coincident]") {
  for (const glm::dmat4& map : {glm::dmat4(1.0), moved({1, 2, 0}) * turned(1.3),
                                turned(1.1) * glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1))}) {
    for (const double gap : {0.0, 0.9 * tolerance, -0.9 * tolerance}) {
      for (const auto& [one, other] : curved_twins(gap)) {
        // Turned about its own axis, and over, which changes nothing; the slope does.
        const glm::dmat4 spun = glm::rotate(map, 0.3, glm::dvec3(0, 1, 0));
        CAPTURE(one.index(), other.index(), gap);
        const CoincidentSurfaces surfaces = found({placed(one, map), placed(other, spun)});
        CHECK(surfaces.surfaces() == 1);
        CHECK(surfaces.place(0, 0) == Place{.surface = 0});
        CHECK(surfaces.place(1, 0) == Place{.surface = 0});
      }
    }
    for (const double gap : {1.1 * tolerance, -1.1 * tolerance}) {
      for (const auto& [one, other] : curved_twins(gap)) {
        CAPTURE(one.index(), other.index(), gap);
        CHECK_FALSE(found({placed(one, map), placed(other, map)}).any());
      }
    }
    for (const auto& [one, other] : curved_twins(0.0)) {
      CAPTURE(one.index(), other.index());
      const glm::dmat4 aside = map * moved({2.0 * tolerance, 0, 0});
      CHECK_FALSE(found({placed(one, map), placed(other, aside)}).any());
    }
  }
}

TEST_CASE("a stretched ball is the one with other numbers", "[geometry][coincident]") {
  const glm::dmat4 stretch = glm::scale(turned(0.4), glm::dvec3(2.0, 1.0, 0.5));
  // Twice as large in a frame half as large, and turned so that its axes are others.
  const glm::dmat4 quarter = glm::rotate(stretch, 0.5 * M_PI, glm::dvec3(0, 1, 0));
  const glm::dmat4 other = quarter * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
  CHECK(found({placed(Sphere{.radius = 1.0}, stretch), placed(Sphere{.radius = 2.0}, other)})
            .surfaces() == 1);
  CHECK_FALSE(found({placed(Sphere{.radius = 1.0}, stretch),
                     placed(Sphere{.radius = 2.0 + 8.0 * tolerance}, other)})
                  .any());
}

TEST_CASE("a capsule's balls are pieces, and so are caps", "[geometry][coincident]") {
  const CoincidentSurfaces capsule =
      found({placed(Capsule{.height = 2.0, .radius_top = 0.5, .radius_bottom = 1.0}, turned(0.3)),
             placed(Sphere{.radius = 0.5}, turned(0.3) * moved({0, 1, 0}))});
  CHECK(capsule.surfaces() == 1);
  CHECK(capsule.place(0, 2).surface == 0);
  CHECK_FALSE(capsule.flat(0));
  CHECK(capsule.largest(0) == CoincidentSurfaces::PieceId{.part = 0, .piece = 2});
  CHECK(capsule.place(0, 1).surface == none);
  CHECK(capsule.place(1, 0).surface == 0);
  // A cone without a lower cap stands on its point; its upper cap is piece 1.
  const CoincidentSurfaces cap =
      found({placed(Cylinder{.height = 2.0, .radius_top = 0.5, .radius_bottom = 0.0}, turned(0.3)),
             placed(Box{.size = glm::dvec3(3.0)}, turned(0.3) * moved({0, 2.5, 0}))});
  CHECK(cap.surfaces() == 1);
  CHECK(cap.place(0, 1) == Place{.surface = 0, .reversed = true});
  CHECK(cap.flat(0));
  CHECK(cap.largest(0) == CoincidentSurfaces::PieceId{.part = 1, .piece = 2});
  CHECK(cap.place(1, 2) == Place{.surface = 0});
}

TEST_CASE("half-spaces share their plane, whole", "[geometry][coincident]") {
  const glm::dmat4 map = turned(0.9);
  const CoincidentSurfaces surfaces =
      found({placed(Box{.size = glm::dvec3(2.0)}, map), placed(HalfSpace{}, map * moved({0, 1, 0})),
             placed(HalfSpace{}, map * glm::rotate(moved({7, 1, 0}), M_PI, glm::dvec3(1, 0, 0)))});
  CHECK(surfaces.surfaces() == 1);
  CHECK(surfaces.place(0, 3) == Place{.surface = 0});
  CHECK(surfaces.place(1, 0) == Place{.surface = 0});
  CHECK(surfaces.place(2, 0) == Place{.surface = 0, .reversed = true});
  // Tilted so that it leaves the plane within the whole.
  const glm::dmat4 tilted = map * glm::rotate(moved({0, 1, 0}), tolerance, glm::dvec3(1, 0, 0));
  CHECK_FALSE(
      found({placed(HalfSpace{}, map * moved({0, 1, 0})), placed(HalfSpace{}, tilted)}).any());
}

TEST_CASE("no chain: a piece joins the first surface it is near, not a piece of it",
          "[geometry][coincident]") {
  // Tops at 0, 0.8 and 1.6 tolerances; the widths tell which comes first.
  const auto tops = [](const std::array<double, 3>& width) {
    std::vector<PlacedShape> boxes;
    for (std::size_t i = 0; i < 3; ++i) {
      const double top = 0.8 * tolerance * static_cast<double>(i);
      const double height = 1.0 + 0.3 * static_cast<double>(i);
      boxes.push_back(placed(Box{.size = {width[i], height, width[i] + 0.01}},
                             moved({0, top - 0.5 * height, 0})));
    }
    return found(boxes);
  };
  const CoincidentSurfaces lowest = tops({3.0, 2.0, 1.0});
  CHECK(lowest.place(0, 3).surface == 0);
  CHECK(lowest.place(1, 3).surface == 0);
  CHECK(lowest.place(2, 3).surface == none);
  const CoincidentSurfaces middle = tops({2.0, 3.0, 1.0});
  CHECK(middle.place(0, 3).surface == 0);
  CHECK(middle.place(1, 3).surface == 0);
  CHECK(middle.place(2, 3).surface == 0);
}

TEST_CASE("a part thinner than the tolerance shares a surface with itself",
          "[geometry][coincident]") {
  const CoincidentSurfaces thin =
      found({placed(Box{.size = {2, 0.5 * tolerance, 2}}, turned(1.0))});
  CHECK(thin.surfaces() == 1);
  CHECK(thin.place(0, 2).surface == 0);
  CHECK(thin.place(0, 3).surface == 0);
  CHECK(thin.place(0, 2).reversed != thin.place(0, 3).reversed);
  CHECK_FALSE(found({placed(Box{.size = {2, 2.0 * tolerance, 2}}, turned(1.0))}).any());
}

TEST_CASE("triangles lie in the faces of a box", "[geometry][coincident]") {
  const TriangleMesh mesh = tessellate(Box{.size = {2, 1, 2}}, 0.0);
  for (const glm::dmat4& map : maps()) {
    CoincidentSurfaces surfaces(whole, tolerance);
    const PlacedShape box = placed(Box{.size = {3, 1, 1.5}}, map * moved({0, 0.9 * tolerance, 0}));
    surfaces.add(box, everywhere);
    surfaces.add(mesh, Affine(map), everywhere);
    surfaces.find();
    CHECK(surfaces.surfaces() == 2);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      CAPTURE(i, mesh.faces[i]);
      const bool flush = mesh.faces[i] == 2 || mesh.faces[i] == 3;
      const Place expected = flush ? surfaces.place(0, mesh.faces[i]) : Place{};
      CHECK(surfaces.place(1, i) == expected);
      CHECK(flush == (surfaces.place(1, i).surface != none));
    }
  }
}

TEST_CASE("a line passes through a surface where it does so through any piece of it",
          "[geometry][coincident]") {
  Random random(2);
  for (const glm::dmat4& map : maps()) {
    for (const auto& [one, other] : curved_twins(0.9 * tolerance)) {
      const CoincidentSurfaces surfaces = found({placed(one, map), placed(other, map)});
      int near = 0;
      for (int i = 0; i < 100; ++i) {
        const glm::dvec3 to(map * glm::dvec4(uniform(random, -1, 1), uniform(random, -0.4, 0.4),
                                             uniform(random, -1, 1), 1.0));
        const glm::dvec3 from(uniform(random, -9, 9), uniform(random, -9, 9), 8.0);
        const Ray ray{.origin = from, .direction = to - from};
        std::array<Crossings, 2> crossings;
        placed(one, map).cross(ray, crossings[0]);
        placed(other, map).cross(ray, crossings[1]);
        for (const Crossing& a : crossings[0]) {
          for (const Crossing& b : crossings[1]) {
            const double cosine = std::abs(glm::dot(glm::normalize(ray.direction), a.normal));
            if (a.piece == 0 && b.piece == 0 && a.entering == b.entering && cosine > 0.1 &&
                std::abs(a.t - b.t) < 1e-4 && surfaces.any()) {
              const double t = surfaces.passage(0, ray, a.t, a.entering);
              REQUIRE(surfaces.passage(0, ray, b.t, b.entering) == t);
              // The surface is the one or the other.
              REQUIRE(std::min(std::abs(t - a.t), std::abs(t - b.t)) < 1e-12);
              ++near;
            }
          }
        }
      }
      CHECK((near > 10 || !surfaces.any()));
    }
  }
}

TEST_CASE("pieces that do not come by are left out", "[geometry][coincident]") {
  const std::vector<PlacedShape> boxes{placed(Box{}, moved({0, 0, 0})),
                                       placed(Box{}, moved({1, 0, 0}))};
  CHECK(found(boxes).surfaces() == 5);
  const CoincidentSurfaces near = found(boxes, {.min{-1, 0.4, -1}, .max{3, 0.6, 1}});
  CHECK(near.surfaces() == 4);  // all but y = -0.5
  CHECK(near.place(0, 2).surface == none);
  CHECK_FALSE(found(boxes, {}).any());
}

TEST_CASE("solids far from the origin share what they share there", "[geometry][coincident]") {
  const glm::dvec3 far(5e9, -3e9, 1e9);
  const Bounds there{.min = far - 5.0, .max = far + 5.0};
  const auto sharing = [&](double gap) {
    CoincidentSurfaces surfaces(there, coincidence_tolerance(there));
    const glm::dmat4 map = moved(far) * turned(0.7);
    const PlacedShape below = placed(Box{.size = {2, 1, 3}}, map);
    const PlacedShape above = placed(Box{.size = {1, 1, 1}}, map * moved({0, 1.0 + gap, 0}));
    surfaces.add(below, everywhere);
    surfaces.add(above, everywhere);
    surfaces.find();
    return surfaces.any();
  };
  CHECK(sharing(0.0));
  CHECK_FALSE(sharing(1e-4));
}

// The rule as it is written, with planes alone, by looking at all pairs.
struct Face {
  std::array<glm::dvec3, 4> corner;
  glm::dvec3 normal;
  double area = 0.0;
  std::uint32_t part = 0;
  std::uint32_t piece = 0;
};

std::vector<Face> faces_of(const std::vector<std::pair<Box, glm::dmat4>>& boxes) {
  std::vector<Face> faces;
  for (std::uint32_t part = 0; part < boxes.size(); ++part) {
    const auto& [box, map] = boxes[part];
    for (int piece = 0; piece < 6; ++piece) {
      Face face{.part = part, .piece = static_cast<std::uint32_t>(piece)};
      for (int k = 0; k < 4; ++k) {
        glm::dvec3 at;
        at[piece / 2] = piece % 2 == 0 ? -1.0 : 1.0;
        at[(piece / 2 + 1) % 3] = k == 0 || k == 3 ? -1.0 : 1.0;
        at[(piece / 2 + 2) % 3] = k < 2 ? -1.0 : 1.0;
        face.corner[static_cast<std::size_t>(k)] =
            glm::dvec3(map * glm::dvec4(0.5 * box.size * at, 1.0));
      }
      const glm::dvec3 across =
          glm::cross(face.corner[1] - face.corner[0], face.corner[3] - face.corner[0]);
      face.area = glm::length(across);
      face.normal = across / face.area * (piece % 2 == 0 ? -1.0 : 1.0);
      faces.push_back(face);
    }
  }
  std::ranges::stable_sort(faces, [](const Face& a, const Face& b) {
    return static_cast<float>(a.area) > static_cast<float>(b.area);
  });
  return faces;
}

TEST_CASE("what is found is what looking at all pairs finds", "[geometry][coincident]") {
  Random random(5);
  int shared = 0;
  int apart = 0;
  for (int model = 0; model < 60; ++model) {
    // Boxes on a lattice of some turn, some of them very flat or narrow, moved by about the
    // tolerance and tilted so that their corners move by about as much.
    const glm::dmat4 frame = turned(uniform(random, 0, 3));
    std::vector<std::pair<Box, glm::dmat4>> boxes;
    std::vector<PlacedShape> parts;
    for (int i = 0; i < 30; ++i) {
      Box box;
      glm::dvec3 at;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = static_cast<double>(random() % 4) - 2.0;
        box.size[axis] = random() % 4 == 0 ? std::pow(10.0, -uniform(random, 0, 3))
                                           : static_cast<double>(1 + random() % 2);
        at[axis] = low + 0.5 * box.size[axis] + uniform(random, -1.5, 1.5) * tolerance;
      }
      const double length = glm::length(box.size);
      const glm::dmat4 map = glm::rotate(
          frame * moved(at), uniform(random, 0, 1) * tolerance / length,
          glm::normalize(glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), 1)));
      boxes.emplace_back(box, map);
      parts.push_back(placed(box, map));
    }
    const CoincidentSurfaces surfaces = found(parts);

    const std::vector<Face> faces = faces_of(boxes);
    std::vector<std::size_t> leader(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      leader[i] = i;
      for (std::size_t k = 0; k < i && leader[i] == i; ++k) {
        const bool near = std::ranges::all_of(faces[i].corner, [&](const glm::dvec3& corner) {
          return std::abs(glm::dot(faces[k].normal, corner - faces[k].corner[0])) <= tolerance;
        });
        if (leader[k] == k && near) {
          leader[i] = k;
        }
      }
    }
    const auto place = [&](std::size_t i) { return surfaces.place(faces[i].part, faces[i].piece); };
    for (std::size_t i = 0; i < faces.size(); ++i) {
      bool expected = false;
      for (std::size_t k = 0; k < faces.size(); ++k) {
        const bool with = leader[i] == leader[k];
        const bool reversed = glm::dot(faces[i].normal, faces[k].normal) < 0.0;
        expected = expected || (with && (faces[i].part != faces[k].part || reversed));
        if (with && place(i).surface != none) {
          REQUIRE(place(i).surface == place(k).surface);
          REQUIRE((place(i).reversed != place(k).reversed) == reversed);
        } else if (!with && place(i).surface != none) {
          REQUIRE(place(i).surface != place(k).surface);
        }
      }
      REQUIRE((place(i).surface != none) == expected);
      ++(expected ? shared : apart);
    }
  }
  CHECK(shared > 3000);
  CHECK(apart > 1000);
}

}  // namespace
}  // namespace raycat
