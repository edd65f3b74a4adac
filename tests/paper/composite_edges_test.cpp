// Section 3.1: edges between the primitive surfaces of composite objects. What the edge map
// shows is compared with the curves that geometry says must be there, both ways.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "edges/edge_map.hpp"
#include "io/load_scene.hpp"
#include "render/render.hpp"
#include "support/scenes.hpp"

namespace raycat {
namespace {

constexpr int size = 320;
constexpr double tau = 2.0 * std::numbers::pi;

using Curve = std::vector<glm::dvec3>;

Curve segment(const glm::dvec3& a, const glm::dvec3& b) {
  Curve curve;
  for (int i = 0; i <= 2000; ++i) {
    curve.push_back(glm::mix(a, b, i / 2000.0));
  }
  return curve;
}

Curve circle(const glm::dvec3& centre, const glm::dvec3& normal, double radius) {
  const glm::dvec3 n = glm::normalize(normal);
  const glm::dvec3 u = glm::normalize(
      glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(n, u);
  Curve curve;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = tau * i / 4000;
    curve.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return curve;
}

// Where rays from `eye` touch a sphere.
Curve contour(const glm::dvec3& centre, double radius, const glm::dvec3& eye) {
  const glm::dvec3 way = eye - centre;
  const double square = glm::dot(way, way);
  return circle(centre + way * (radius * radius / square), way,
                radius * std::sqrt(1.0 - radius * radius / square));
}

// The edge map at the first level, without lights: surfaces alone.
class View {
 public:
  View(const Scene& scene, const Camera& camera)
      : accel_(scene), camera_(camera), plane_(camera, size, size) {
    map_ = detect_edges(
        render(
            accel_, camera,
            {.width = size, .height = size, .levels = 1, .threads = 2, .detail = {.lights = false}})
            .categories);
  }

  const EdgeMap& map() const { return map_; }

  // Does nothing lie before `point`?
  bool sees(const glm::dvec3& point) {
    const glm::dvec3 way = point - camera_.eye;
    const auto hit = accel_.closest({.origin = camera_.eye, .direction = way}, scratch_);
    return !hit || hit->t > 1.0 - 1e-7;
  }

  // Points of `curves` that are in view and have no edge pixel within one pixel of them.
  int missing(const std::vector<Curve>& curves, int& tried) {
    int count = 0;
    for (const Curve& curve : curves) {
      for (const glm::dvec3& point : curve) {
        const glm::dvec2 seen = plane_.project(point);
        if (sees(point) && seen.x > 2 && seen.y > 2 && seen.x < size - 2 && seen.y < size - 2) {
          ++tried;
          count += edge_near(seen) ? 0 : 1;
        }
      }
    }
    return count;
  }

  // Edge pixels farther than one pixel from every one of `curves`, seen or hidden.
  int surplus(const std::vector<Curve>& curves) const {
    std::vector<std::uint8_t> allowed(size * size, 0);
    for (const Curve& curve : curves) {
      for (const glm::dvec3& point : curve) {
        const glm::dvec2 seen = plane_.project(point);
        for (int y = static_cast<int>(seen.y) - 4; y < seen.y + 4; ++y) {
          for (int x = static_cast<int>(seen.x) - 4; x < seen.x + 4; ++x) {
            if (x >= 0 && y >= 0 && x < size && y < size && distance(x, y, seen) <= 1.0) {
              allowed[static_cast<std::size_t>(y * size + x)] = 1;
            }
          }
        }
      }
    }
    int count = 0;
    for (std::size_t i = 0; i < allowed.size(); ++i) {
      count += map_.pixels[i] != 0 && allowed[i] == 0 ? 1 : 0;
    }
    return count;
  }

 private:
  // From `seen` to the square of samples of pixel (x, y): the centres of the pixels (x, y) to
  // (x + 1, y + 1).
  static double distance(int x, int y, const glm::dvec2& seen) {
    const double dx = std::max(std::abs(seen.x - (x + 1.0)) - 0.5, 0.0);
    const double dy = std::max(std::abs(seen.y - (y + 1.0)) - 0.5, 0.0);
    return std::hypot(dx, dy);
  }

  bool edge_near(const glm::dvec2& seen) const {
    for (int y = static_cast<int>(seen.y) - 3; y <= seen.y + 2; ++y) {
      for (int x = static_cast<int>(seen.x) - 3; x <= seen.x + 2; ++x) {
        if (x >= 0 && y >= 0 && x < size && y < size && map_.at(x, y) &&
            distance(x, y, seen) <= 1.0) {
          return true;
        }
      }
    }
    return false;
  }

  Accel accel_;
  Camera camera_;
  ImagePlane plane_;
  EdgeMap map_;
  Solid::Scratch scratch_;
};

// The edges of a box from -half to half, placed by `place`.
std::vector<Curve> box_edges(const glm::dvec3& half, const glm::dmat4& place) {
  std::vector<Curve> edges;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) {
      glm::dvec3 a = half;
      a[(axis + 1) % 3] *= (k & 1) != 0 ? 1 : -1;
      a[(axis + 2) % 3] *= (k & 2) != 0 ? 1 : -1;
      glm::dvec3 b = a;
      b[axis] = -a[axis];
      edges.push_back(
          segment(glm::dvec3(place * glm::dvec4(a, 1)), glm::dvec3(place * glm::dvec4(b, 1))));
    }
  }
  return edges;
}

TEST_CASE("a cube seen from a corner has nine edges and nothing else", "[paper][composite]") {
  SceneBuilder builder;
  builder.shape("cube", Box{.size = {2, 2, 2}}, at(0, 0, 0), builder.material({}));
  const Scene scene = builder.take();
  const Camera camera = look_at({5, 4, 6}, {0, 0, 0}, {0, 1, 0});
  View view(scene, camera);
  std::vector<Curve> visible;
  for (const Curve& edge : box_edges({1, 1, 1}, glm::dmat4(1.0))) {
    // The three at the hidden corner (-1, -1, -1) have both their faces turned away.
    const glm::dvec3 middle = edge[edge.size() / 2];
    const int away =
        (middle.x < -0.5 ? 1 : 0) + (middle.y < -0.5 ? 1 : 0) + (middle.z < -0.5 ? 1 : 0);
    if (away < 2) {
      visible.push_back(edge);
    }
  }
  REQUIRE(visible.size() == 9);
  int tried = 0;
  CHECK(view.missing(visible, tried) == 0);
  CHECK(tried > 9 * 1000);
  CHECK(view.surplus(visible) == 0);
  CHECK(view.map().count() > 500);
}

TEST_CASE("a cube of triangles has the same edges and no diagonals", "[paper][composite]") {
  SurfaceMesh mesh;
  mesh.triangles = triangulate(
      {{-1, -1, -1},
       {1, -1, -1},
       {1, 1, -1},
       {-1, 1, -1},
       {-1, -1, 1},
       {1, -1, 1},
       {1, 1, 1},
       {-1, 1, 1}},
      std::vector<std::vector<std::uint32_t>>{
          {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}});
  mesh.triangles.faces = group_faces(mesh.triangles.positions, mesh.triangles.triangles, {}).faces;
  mesh.triangles.face_count = *std::ranges::max_element(mesh.triangles.faces) + 1;
  REQUIRE(mesh.triangles.face_count == 6);
  SceneBuilder builder;
  builder.mesh("cube", mesh, at(0, 0, 0), builder.material({}));
  const Scene scene = builder.take();
  View view(scene, look_at({5, 4, 6}, {0, 0, 0}, {0, 1, 0}));
  int tried = 0;
  CHECK(view.surplus(box_edges({1, 1, 1}, glm::dmat4(1.0))) == 0);
  CHECK(view.missing(box_edges({1, 1, 1}, glm::dmat4(1.0)), tried) == 0);
  CHECK(tried > 9 * 1000);
}

TEST_CASE("a cylinder has its rims and its outline", "[paper][composite]") {
  SceneBuilder builder;
  builder.shape("cylinder", Cylinder{.height = 2, .radius_top = 1, .radius_bottom = 1}, at(0, 0, 0),
                builder.material({}));
  const Scene scene = builder.take();
  const glm::dvec3 eye(4, 3.5, 5);
  View view(scene, look_at(eye, {0, 0, 0}, {0, 1, 0}));
  const std::vector<Curve> rims{circle({0, 1, 0}, {0, 1, 0}, 1), circle({0, -1, 0}, {0, 1, 0}, 1)};
  int tried = 0;
  CHECK(view.missing(rims, tried) == 0);
  CHECK(tried > 5000);  // all of the upper rim, the front of the lower one

  // The outline is where the lines of sight touch the side: x cos a + z sin a = 1 at the eye.
  std::vector<Curve> curves(rims);
  const double away = std::hypot(eye.x, eye.z);
  for (const double turn : {std::acos(1.0 / away), -std::acos(1.0 / away)}) {
    const double angle = std::atan2(eye.z, eye.x) + turn;
    curves.push_back(
        segment({std::cos(angle), -1, std::sin(angle)}, {std::cos(angle), 1, std::sin(angle)}));
  }
  CHECK(view.missing(curves, tried) == 0);
  CHECK(view.surplus(curves) == 0);
}

TEST_CASE("a drilled block of one material shows its faces' borders", "[paper][composite]") {
  SceneBuilder builder;
  builder.pair("block", Operation::difference, Box{.size = {3, 1, 2}}, at(0, 0, 0),
               Cylinder{.height = 4, .radius_top = 0.6, .radius_bottom = 0.6}, at(0.3, 0, 0.1),
               builder.material({}));
  const Scene scene = builder.take();
  View view(scene, look_at({2.5, 5, 4}, {0, 0, 0}, {0, 1, 0}));
  std::vector<Curve> curves = box_edges({1.5, 0.5, 1}, glm::dmat4(1.0));
  const std::vector<Curve> rims{circle({0.3, 0.5, 0.1}, {0, 1, 0}, 0.6),
                                circle({0.3, -0.5, 0.1}, {0, 1, 0}, 0.6)};
  curves.insert(curves.end(), rims.begin(), rims.end());
  int tried = 0;
  CHECK(view.missing(rims, tried) == 0);
  CHECK(tried > 4000 + 500);  // the upper rim, and the lower one through the hole
  CHECK(view.missing(curves, tried) == 0);
  CHECK(view.surplus(curves) == 0);
}

TEST_CASE("the set operations of Fig. 10 meet in circles", "[paper][fig10]") {
  SceneFile file = load_scene(std::string(RAYCAT_ASSETS) + "/scenes/fig10.gltf");
  Scene& scene = file.scene;
  // The floor goes: its horizon is not at a place that geometry knows.
  std::erase_if(scene.solids,
                [](const SolidObject& object) { return !object.solid.bounds().finite(); });
  REQUIRE(scene.solids.size() == 3);
  const Camera& camera = scene.cameras.front();
  View view(scene, camera);

  std::vector<Curve> seams;    // where box and sphere meet: circles on the planes of the faces
  std::vector<Curve> creases;  // the box's own edges, where the operation keeps them
  std::vector<Curve> outlines;
  for (const SolidObject& object : scene.solids) {
    glm::dmat4 box(1.0);
    glm::dvec3 half(0.0);
    glm::dvec3 centre(0.0);
    double radius = 0.0;
    for (const CsgLeaf& leaf : object.solid.tree().leaves()) {
      if (const auto* shape = std::get_if<Box>(&leaf.shape.shape())) {
        box = leaf.shape.transform().matrix();
        half = 0.5 * shape->size;
      } else {
        centre = leaf.shape.transform().point(glm::dvec3(0.0));
        radius = std::get<Sphere>(leaf.shape.shape()).radius;
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 normal(side * glm::normalize(glm::dvec3(box[axis])));
        seams.push_back(circle(centre + half[axis] * normal, normal,
                               std::sqrt(radius * radius - half[axis] * half[axis])));
      }
    }
    const std::vector<Curve> edges = box_edges(half, box);
    if (object.solid.tree().nodes().back().operation != Operation::intersection) {
      creases.insert(creases.end(), edges.begin(), edges.end());
    }
    outlines.push_back(contour(centre, radius, camera.eye));
  }
  int tried = 0;
  CHECK(view.missing(seams, tried) == 0);
  CHECK(tried > 20'000);
  tried = 0;
  CHECK(view.missing(creases, tried) == 0);
  CHECK(tried > 20'000);
  std::vector<Curve> all(seams);
  all.insert(all.end(), creases.begin(), creases.end());
  all.insert(all.end(), outlines.begin(), outlines.end());
  CHECK(view.surplus(all) == 0);
  CHECK(view.map().count() > 2000);
}

}  // namespace
}  // namespace raycat
