#include "reference/coincident_scenes.hpp"

#include <array>

#include <glm/gtc/matrix_transform.hpp>

#include "geometry/tessellate.hpp"
#include "reference/scene_maker.hpp"

namespace raycat::reference {
namespace {

glm::dmat4 at(const glm::dvec3& place) { return glm::translate(glm::dmat4(1.0), place); }

class Maker : SceneMaker {
 public:
  using SceneMaker::SceneMaker;

  Scene operator()() {
    const double angle = between(0, 3);
    world_ = glm::rotate(at(vec(-3, 3)), angle, vec(-1, 1) + glm::dvec3(0, 1.5, 0));
    add_materials();
    scene_.background = colour(0.0, 1.0);
    scene_.ambient_light = colour(0.0, 0.4);
    const bool floor_first = below(2) == 0;
    if (floor_first) {
      add_floor();
    }
    const unsigned groups = 1 + below(2);
    for (unsigned i = 0; i < groups; ++i) {
      const glm::dvec3 place{i == 0 ? -1.2 : 1.2, 0.0, between(-0.5, 0.5)};
      const std::array add{&Maker::add_row, &Maker::add_stack, &Maker::add_inlay,
                           &Maker::add_filled_glass, &Maker::add_decal};
      (this->*add[below(5)])(place);
    }
    if (!floor_first) {
      add_floor();
    }
    const unsigned lights = 1 + below(3);
    for (unsigned i = 0; i < lights; ++i) {
      add_light();
    }
    const glm::dvec3 eye{between(-4, 4), between(-1, 4), below(3) == 0 ? -7.0 : 7.0};
    Camera camera = look_at(in_world(eye), in_world({between(-0.5, 0.5), 0.3, 0.0}), {0, 1, 0.1});
    camera.half_height = 0.35;
    scene_.cameras.push_back(below(5) == 0 ? orthographic(camera, 7.0) : camera);
    return std::move(scene_);
  }

 private:
  // What lets light through reflects nothing, so that it does not matter how a mirrored ray goes on
  // within a place where surfaces coincide, and is not thinner than the air, so that only leaving
  // it is totally reflected.
  void add_materials() {
    for (int i = 0; i < 2; ++i) {
      add_material({.ambient = colour(0, 0.5),
                    .diffuse = colour(0, 1),
                    .specular = colour(0, 0.4),
                    .shininess = 10.0f});
      const auto ior = static_cast<float>(between(1.1, 2.0));
      add_material({.diffuse = colour(0, 0.3),
                    .transmission = colour(0.3, 1),
                    .ior = ior,
                    .absorption = below(2) == 0 ? colour(0, 0.5) : glm::vec3(0.0f)});
    }
    add_material({.diffuse = colour(0, 0.3), .reflection = colour(0.3, 0.9)});
    const auto covered = static_cast<float>(between(0.1, 0.9));
    add_material({.ambient = colour(0, 0.5),
                  .diffuse = colour(0, 1),
                  .transmission = glm::vec3(1.0f - covered),
                  .thin = true,
                  .blend = true,
                  .alpha = covered});
  }

  MaterialId any_material() { return MaterialId{below(6)}; }
  MaterialId any_glass() { return MaterialId{below(2) == 0 ? 1u : 3u}; }

  // A box by its lowest corner, analytic or of triangles.
  void add_box(const glm::dvec3& low, const glm::dvec3& size, MaterialId material) {
    if (below(3) == 0) {
      add_mesh({.triangles = tessellate(Box{.size = size}, 0.1)}, at(low + 0.5 * size), material);
    } else {
      add_solid(Box{.size = size}, at(low + 0.5 * size), material);
    }
  }

  void add_floor() {
    const MaterialId material{below(3) == 0 ? 4u : 0u};
    switch (below(4)) {
      case 0:
        add_solid(HalfSpace{}, glm::dmat4(1.0), material);
        break;
      case 1:
        add_box({-4, -1, -4}, {8, 1, 8}, any_glass());
        break;
      default:
        add_box({-4, -1, -4}, {8, 1, 8}, material);
    }
  }

  void add_row(const glm::dvec3& place) {
    double x = place.x - 1.0;
    for (int i = 0; i < 3; ++i) {
      const double width = between(0.3, 1.0);
      add_box({x, 0.0, place.z - 0.5}, {width, between(0.3, 1.2), 1.0}, any_material());
      x += width;
    }
  }

  void add_stack(const glm::dvec3& place) {
    double y = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double height = between(0.2, 0.6);
      const double width = between(0.5, 1.2);
      if (below(3) == 0) {
        add_solid(Cylinder{.height = height, .radius_top = width / 2, .radius_bottom = width / 2},
                  at({place.x, y + height / 2, place.z}), any_material());
      } else {
        add_box({place.x - width / 2, y, place.z - 0.4}, {width, height, 0.8}, any_material());
      }
      y += height;
    }
  }

  // A slab, and what is let into its upper side.
  void add_inlay(const glm::dvec3& place) {
    const bool slab_first = below(2) == 0;
    const auto add_slab = [&] {
      add_box({place.x - 1.0, 0.0, place.z - 0.8}, {2.0, 0.6, 1.6}, any_material());
    };
    if (slab_first) {
      add_slab();
    }
    add_box({place.x - 0.5, 0.2, place.z - 0.5}, {0.8, 0.4, 1.0}, any_material());
    if (!slab_first) {
      add_slab();
    }
  }

  void add_filled_glass(const glm::dvec3& place) {
    const MaterialId glass = any_glass();
    const bool round = below(2) == 0;
    const Shape outer =
        round ? Shape(Sphere{.radius = 0.9})
              : Shape(Cylinder{.height = 1.6, .radius_top = 0.8, .radius_bottom = 0.8});
    const Shape inner =
        round ? Shape(Sphere{.radius = 0.6})
              : Shape(Cylinder{.height = 1.2, .radius_top = 0.6, .radius_bottom = 0.6});
    const glm::dmat4 middle = at(place + glm::dvec3(0.0, round ? 0.9 : 0.8, 0.0));
    const bool filling_first = below(2) == 0;
    if (filling_first) {
      add_solid(inner, middle, any_material());
    }
    name_object();
    CsgTree tree;
    const std::array operands{tree.add(leaf(outer, middle)), tree.add(leaf(inner, middle))};
    tree.add(Operation::difference, operands);
    add_object(std::move(tree), {glass, glass});
    if (!filling_first) {
      add_solid(inner, middle, any_material());
    }
  }

  // A square in the front of a wall, which faces as it does or the other way.
  void add_decal(const glm::dvec3& place) {
    SurfaceMesh square{
        .triangles = {.positions = {{-0.5, -0.4, 0}, {0.5, -0.4, 0}, {0.5, 0.4, 0}, {-0.5, 0.4, 0}},
                      .triangles = {{0, 1, 2}, {0, 2, 3}},
                      .faces = {0, 0},
                      .face_count = 1}};
    if (below(2) == 0) {
      square.triangles.triangles = {{0, 2, 1}, {0, 3, 2}};
    }
    const MaterialId material{std::array{0u, 2u, 4u, 5u}[below(4)]};
    const bool wall_first = below(2) == 0;
    const MaterialId of_wall = any_material();
    if (wall_first) {
      add_box({place.x - 1.0, 0.0, place.z - 0.3}, {2.0, 1.4, 0.3}, of_wall);
    }
    add_mesh(std::move(square), at({place.x, 0.7, place.z}), material);
    if (!wall_first) {
      add_box({place.x - 1.0, 0.0, place.z - 0.3}, {2.0, 1.4, 0.3}, of_wall);
    }
  }
};

}  // namespace

Scene coincident_scene(unsigned seed) { return Maker(seed)(); }

}  // namespace raycat::reference
